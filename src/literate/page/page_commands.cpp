// SPDX-License-Identifier: GPL-3.0-or-later
#include "literate/page/page_writer.hpp"

namespace literate {

const std::unordered_map<std::string_view, PageWriter::Handler>& PageWriter::handlers() {
  static const std::unordered_map<std::string_view, Handler> all = [] {
    std::unordered_map<std::string_view, Handler> table;
    const auto add = [&](Handler handler, std::initializer_list<std::string_view> names) {
      for (const std::string_view name : names) table[name] = handler;
    };
    add(&PageWriter::style_text,
        {"textbf", "textit", "textsl", "emph", "texttt", "textsf", "textsc", "underline", "uline",
         "textsuperscript", "textsubscript", "textrm", "textup", "textmd", "textnormal", "text",
         "ensuremath"});
    add(&PageWriter::style_from_here, {"bfseries", "bf", "itshape", "it", "em", "slshape",
                                       "ttfamily", "tt", "sffamily", "scshape"});
    add(&PageWriter::symbol, {"%",
                              "&",
                              "#",
                              "_",
                              "$",
                              "{",
                              "}",
                              " ",
                              ",",
                              "thinspace",
                              ":",
                              ";",
                              "!",
                              "-",
                              "quad",
                              "qquad",
                              "enspace",
                              "hfill",
                              "percent",
                              "ldots",
                              "dots",
                              "textellipsis",
                              "textendash",
                              "textemdash",
                              "textbar",
                              "textless",
                              "textgreater",
                              "textunderscore",
                              "textbackslash",
                              "textasciicircum",
                              "textasciitilde",
                              "textbullet",
                              "textdegree",
                              "textmu",
                              "textonehalf",
                              "textonequarter",
                              "textthreequarters",
                              "texttimes",
                              "textpm",
                              "textperiodcentered",
                              "textquoteleft",
                              "textquoteright",
                              "textquotedblleft",
                              "textquotedblright",
                              "textbraceleft",
                              "textbraceright",
                              "textsection",
                              "S",
                              "P",
                              "copyright",
                              "textcopyright",
                              "textregistered",
                              "texttrademark",
                              "pounds",
                              "euro",
                              "texteuro",
                              "ss",
                              "o",
                              "O",
                              "l",
                              "L",
                              "ae",
                              "AE",
                              "oe",
                              "OE",
                              "aa",
                              "AA",
                              "i",
                              "j",
                              "and",
                              "dag",
                              "ddag",
                              "LaTeX",
                              "TeX",
                              "BibTeX",
                              "slash",
                              "textquotesingle",
                              "textasteriskcentered",
                              "textminus",
                              "guillemotleft",
                              "guillemotright",
                              "checkmark",
                              "allowbreak"});
    add(&PageWriter::accent, {"\"", "'", "`", "^", "~", "c", "v", "H", "=", ".", "u", "r"});
    add(&PageWriter::line_break, {"\\", "newline"});
    add(&PageWriter::boxed, {"mbox", "hbox", "makebox", "fbox", "framebox", "parbox", "raisebox",
                             "hspace", "scalebox", "resizebox", "rotatebox"});
    add(&PageWriter::rule, {"rule"});
    add(&PageWriter::footnote, {"footnote", "thanks"});
    add(&PageWriter::hyperlink, {"url", "href", "doi", "nolinkurl"});
    add(&PageWriter::colored, {"textcolor", "colorbox"});
    add(&PageWriter::number, {"num", "qty", "SI", "unit", "si"});
    add(&PageWriter::group_command, {"par", "begingroup", "bgroup", "endgroup", "egroup"});
    add(&PageWriter::input, {"input", "include", "InputIfFileExists"});
    add(&PageWriter::set_register,
        {"setcounter", "addtocounter", "newcounter", "stepcounter", "refstepcounter"});
    add(&PageWriter::condition, {"iftrue", "iffalse", "ifdim", "ifnum", "ifx", "if", "ifdefined",
                                 "ifcsname", "ifmmode", "ifodd"});
    add(&PageWriter::metadata, {"title", "author", "date"});
    add(&PageWriter::new_environment, {"newenvironment", "renewenvironment"});
    add(&PageWriter::new_theorem, {"newtheorem"});
    add(&PageWriter::math_operator, {"DeclareMathOperator"});
    add(&PageWriter::package, {"usepackage", "documentclass", "RequirePackage"});
    add(&PageWriter::title, {"maketitle"});
    add(&PageWriter::heading,
        {"part", "section", "subsection", "subsubsection", "paragraph", "subparagraph"});
    add(&PageWriter::appendix, {"appendix"});
    add(&PageWriter::begin, {"begin"});
    add(&PageWriter::end, {"end"});
    add(&PageWriter::caption, {"caption"});
    add(&PageWriter::label, {"label"});
    add(&PageWriter::inline_formula, {"("});
    add(&PageWriter::display_formula, {"["});
    add(&PageWriter::table, {"tab"});
    add(&PageWriter::noted_table, {"LiterateNoted", "LiterateNote", "LiterateMark"});
    add(&PageWriter::number_cell, {"LiterateCell", "LiterateMarkedCell"});
    add(&PageWriter::define_name,
        {"LiterateValue", "LiterateRaw", "LiterateRestyled", "LiterateRestyledRaw", "LiterateFlag",
         "LiterateClaim", "LiterateStatement", "LiterateCount", "LiterateQuotation",
         "LiterateStamp"});
    add(&PageWriter::value, {"val"});
    add(&PageWriter::raw_value, {"rawval"});
    add(&PageWriter::flag, {"ifflag"});
    add(&PageWriter::statement, {"statement"});
    add(&PageWriter::claim, {"claim"});
    add(&PageWriter::finding_says, {"findingsays"});
    add(&PageWriter::limit_kind, {"limitkind"});
    add(&PageWriter::claim_count, {"claimcount"});
    add(&PageWriter::verdict_sign, {"verdictsign"});
    add(&PageWriter::quoted, {"quoted", "quotedpage"});
    add(&PageWriter::ledger, {"claimledger"});
    add(&PageWriter::ledger_entry, {"LiterateLedgerEntry"});
    add(&PageWriter::criterion, {"LiterateCriterion"});
    add(&PageWriter::value_index, {"valueindex"});
    add(&PageWriter::index_entry, {"LiterateIndexEntry"});
    add(&PageWriter::provenance, {"provenance"});
    add(&PageWriter::provenance_entry, {"LiterateProvenance", "LiterateFiles", "LiterateFile"});
    add(&PageWriter::repository, {"LiterateRepository"});
    add(&PageWriter::figure, {"fig"});
    add(&PageWriter::picture, {"image", "includegraphics"});
    add(&PageWriter::excerpt, {"excerpt"});
    add(&PageWriter::listing, {"LiterateListing"});
    add(&PageWriter::reference, {"ref", "eqref", "nameref", "pageref"});
    add(&PageWriter::clever_reference,
        {"cref", "Cref", "labelcref", "crefrange", "Crefrange", "autoref"});
    add(&PageWriter::reference_names, {"crefname", "Crefname"});
    add(&PageWriter::citation, {"cite", "citep", "citet", "citealp", "parencite", "textcite"});
    add(&PageWriter::bibliography, {"bibliography", "bibliographystyle"});
    return table;
  }();
  return all;
}

const std::unordered_map<std::string_view, PageWriter::EnvironmentHandler>&
PageWriter::environments() {
  static const std::unordered_map<std::string_view, EnvironmentHandler> all{
      {"abstract", &PageWriter::abstract},
      {"itemize", &PageWriter::list},
      {"enumerate", &PageWriter::list},
      {"description", &PageWriter::list},
      {"quote", &PageWriter::quote},
      {"quotation", &PageWriter::quote},
      {"verse", &PageWriter::quote},
      {"center", &PageWriter::center},
      {"flushleft", &PageWriter::plain_environment},
      {"flushright", &PageWriter::plain_environment},
      {"multicols", &PageWriter::plain_environment},
      {"minipage", &PageWriter::plain_environment},
      {"titlepage", &PageWriter::plain_environment},
      {"small", &PageWriter::plain_environment},
      {"footnotesize", &PageWriter::plain_environment},
      {"appendices", &PageWriter::plain_environment},
      {"figure", &PageWriter::float_environment},
      {"figure*", &PageWriter::float_environment},
      {"wrapfigure", &PageWriter::float_environment},
      {"table", &PageWriter::float_environment},
      {"table*", &PageWriter::float_environment},
      {"tabular", &PageWriter::tabular},
      {"tabular*", &PageWriter::tabular},
      {"tabularx", &PageWriter::tabular},
      {"longtable", &PageWriter::tabular},
      {"findings", &PageWriter::findings},
      {"equation", &PageWriter::equation},
      {"equation*", &PageWriter::equation},
      {"displaymath", &PageWriter::equation},
      {"align", &PageWriter::equations},
      {"align*", &PageWriter::equations},
      {"alignat", &PageWriter::equations},
      {"alignat*", &PageWriter::equations},
      {"flalign", &PageWriter::equations},
      {"flalign*", &PageWriter::equations},
      {"gather", &PageWriter::equations},
      {"gather*", &PageWriter::equations},
      {"multline", &PageWriter::equations},
      {"multline*", &PageWriter::equations},
      {"eqnarray", &PageWriter::equations},
      {"thebibliography", &PageWriter::bibliography_items},
  };
  return all;
}

}  // namespace literate
