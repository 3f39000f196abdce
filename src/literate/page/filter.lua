-- SPDX-License-Identifier: GPL-3.0-or-later
-- What pandoc read of the expanded document, with HTML in place of the marks, and what it did not know told on standard
-- error: a line "unknown:" and the LaTeX, for each piece. The file marks.lua holds what each mark stands for.
local marks = dofile(os.getenv("LITERATE_MARKS"))

local function html(text) return pandoc.RawInline("html", text) end

local function mark_of(element)
  if not element or element.t ~= "Link" then return nil end
  return marks[tonumber(element.target:match("^lit:(%d+)$") or "0")]
end

local languages = {["C++"] = "cpp", Octave = "octave", Fortran = "fortran", LaTeX = "latex", TeX = "latex", make = "makefile"}
local function listing(mark)
  local name = mark.language:gsub("^%[.*%]", "")
  local classes, attributes = {languages[name] or name:lower()}, {}
  if mark.first > 0 then
    classes[2], attributes.startFrom = "numberLines", tostring(mark.first)
  end
  return pandoc.CodeBlock(mark.open, pandoc.Attr("", classes, attributes))
end

-- A center environment that begins with an empty mark is a block of HTML.
local function block(div)
  local first = div.content[1]
  if not div.classes:includes("center") or not first or not first.content then return nil end
  local mark = mark_of(first.content[1])
  if not mark or #first.content[1].content > 0 then return nil end
  if mark.language then return listing(mark) end
  first.content:remove(1)
  while first.content[1] and (first.content[1].t == "Space" or first.content[1].t == "SoftBreak") do
    first.content:remove(1)
  end
  if #first.content == 0 then div.content:remove(1) end
  local blocks = pandoc.List({pandoc.RawBlock("html", mark.open)})
  for _, inner in ipairs(div.content) do
    blocks:insert(mark.plain and inner.t == "Para" and pandoc.Plain(inner.content) or inner)
  end
  blocks:insert(pandoc.RawBlock("html", mark.close))
  return blocks
end

local function inline(link)
  local mark = mark_of(link)
  if not mark then return nil end
  local inlines = pandoc.List({html(mark.open)})
  inlines:extend(link.content)
  inlines:insert(html(mark.close))
  return inlines
end

local spaces = {["\\quad"] = "\u{2003}", ["\\qquad"] = "\u{2003}\u{2003}"}
local function unknown(raw)
  if raw.format ~= "latex" then return nil end
  local space = spaces[raw.text:match("^\\%a+")]
  if space then return raw.t == "RawInline" and pandoc.Str(space) or {} end
  io.stderr:write("unknown: ", (raw.text:gsub("%s+", " ")), "\n")
  return {}
end

-- A formula in a line may break behind a relation, as TeX breaks it; a browser breaks none, so that each part is one of its own.
local function breakable(math)
  if math.mathtype ~= "InlineMath" then return nil end
  local text, parts, from, at, depth = math.text, pandoc.List(), 1, 1, 0
  local deeper = {["{"] = 1, ["\\left"] = 1, ["\\begin"] = 1, ["}"] = -1, ["\\right"] = -1, ["\\end"] = -1}
  while at <= #text do
    local token = text:match("^\\%a+", at) or text:match("^\\.", at) or text:sub(at, at)
    depth = depth + (deeper[token] or 0)
    at = at + #token
    if token == "=" and depth == 0 and at <= #text then
      parts:extend({pandoc.Math("InlineMath", text:sub(from, at - 1)), html("<wbr>")})
      from = at
    end
  end
  if #parts == 0 then return nil end
  parts:insert(pandoc.Math("InlineMath", text:sub(from)))
  return parts
end

-- TeX breaks no line between a formula or a power of ten and what touches it, nor between groups of digits; a browser would.
local function unbroken(inlines)
  local kept, run, has_formula = pandoc.List(), pandoc.List(), false
  local function add_run()
    local is_close = has_formula and (#run > 1 or run[1].t == "Str")
    if is_close then kept:insert(html('<span class="lit-close">')) end
    kept:extend(run)
    if is_close then kept:insert(html("</span>")) end
    run, has_formula = pandoc.List(), false
  end
  for _, inline in ipairs(inlines) do
    local last = run[#run]
    local is_power = inline.t == "Superscript" and last and last.t == "Str" and last.text:match("10$")
    if inline.t == "Str" or inline.t == "Math" or is_power then
      run:insert(inline)
      has_formula = has_formula or inline.t ~= "Str" or inline.text:find("\u{2006}")
    else
      add_run()
      kept:insert(inline)
    end
  end
  add_run()
  return kept
end

-- Drawings of one line stay beside each other, since captions say left and right.
local function row_of_drawings(para)
  local n_drawings = 0
  para:walk({RawInline = function(raw)
    if raw.text:match('^<img class="lit%-drawing"') then n_drawings = n_drawings + 1 end
  end})
  if n_drawings < 2 then return nil end
  return {pandoc.RawBlock("html", '<div class="lit-row" tabindex="0" role="group" aria-label="drawings">'),
          pandoc.Plain(para.content), pandoc.RawBlock("html", "</div>")}
end

local function native_table(tbl)
  tbl.classes = {"lit-table", "lit-prose-table"}
  return tbl
end

-- The contents: the text of each heading, with those of the sections within it below. A part is told by a class.
local function contents(blocks)
  local items = pandoc.List()
  for _, section in ipairs(blocks) do
    local header = section.t == "Div" and section.content[1]
    if header and header.t == "Header" then
      local function nothing() return {} end
      local function inside(link) return link.content end
      local text = header.content:walk({RawInline = nothing, Note = nothing, Link = inside})
      local class = pandoc.utils.stringify(text):match("^Part") and "lit-toc-part" or nil
      local item = pandoc.List({pandoc.Plain({pandoc.Link(text, "#" .. section.identifier, "", {class = class})})})
      local lower = contents(section.content)
      if #lower > 0 then item:insert(pandoc.BulletList(lower)) end
      items:insert(item)
    end
  end
  return items
end

-- Where the element ends that begins at a place with <name>.
local function end_of_element(text, at, name)
  local depth = 0
  repeat
    local first, last, closes = text:find("<(/?)" .. name .. ">", at)
    if not first then return #text end
    depth = depth + (closes == "/" and -1 or 1)
    at = last + 1
  until depth == 0
  return at - 1
end

-- The name of an operator, such as ln, has a thin space beside letters, numbers and bars, and none beside signs and parentheses,
-- as in TeX; pandoc leaves it the spaces of a relation.
local function with_operator_spaces(text)
  local first, last = text:find("<mo>[%a ]*</mo>")
  while first do
    -- With its limits or its exponent.
    local outer = text:sub(1, first - 1):match("<(m[suo][unv]%a*)>$")
    local begin = outer and first - #outer - 2 or first
    local before = text:sub(1, begin - 1)
    local behind = text:sub((outer and end_of_element(text, begin, outer) or last) + 1)
    local closed = before:match("</m(%a+)>$")
    local is_behind_letter = closed and closed ~= "o" or before:find('form="postfix">[^<]*</mo>$')
    local is_before_sign = behind == "" or behind:find("^</")
    while behind:find("^<mspace[^>]*></mspace>") do behind = behind:gsub("^<mspace[^>]*></mspace>", "") end
    while behind:find("^<m%a+>") and not behind:find("^<mo>") do behind = behind:gsub("^<m%a+>", "") end
    -- All large operators, bars and the minus begin with the same byte.
    is_before_sign = is_before_sign or behind:find("^<mo[^>]*>[^|%a<\xe2]")
    local spaced = string.format('<mo lspace="%s" rspace="%s"', is_behind_letter and "0.167em" or "0em",
                                 is_before_sign and "0em" or "0.167em")
    text = text:sub(1, first - 1) .. spaced .. text:sub(first + 3)
    first, last = text:find("<mo>[%a ]*</mo>", first + #spaced)
  end
  return text
end

-- Pandoc stretches every parenthesis, and browsers set one that may stretch twice as wide. Around what is no higher than a letter
-- with its exponent it need not. Rows are told apart by control characters, between which Lua matches pairs.
local function with_plain_fences(text)
  local function plain(row)
    local is_tall = row:find("<mfrac") or row:find("<mtable") or row:find("<mun") or row:find("<mover") or row:find("<msqrt")
    if not is_tall and row:find('^\1<mo stretchy="true" form="prefix">') then return (row:gsub('stretchy="true"', 'stretchy="false"')) end
    return "\1" .. row:sub(2):gsub("%b\1\2", plain)
  end
  text = text:gsub("<mrow>", "\1"):gsub("</mrow>", "\2"):gsub("%b\1\2", plain)
  return (text:gsub("\1", "<mrow>"):gsub("\2", "</mrow>"))
end

-- Sizes of \big and its like, which browsers take with a unit alone, and not below an exponent, which then stands at a space of the
-- same height.
local heights = {["1.2"] = "0.8em", ["1.8"] = "1.1em", ["2.4"] = "1.4em", ["3.0"] = "1.7em"}
local function with_sizes(text)
  text = text:gsub('<msup>(<mo minsize="([%d.]+)".-</mo>)', function(sign, size)
    return sign .. '<msup><mspace height="' .. heights[size] .. '" />'
  end)
  return (text:gsub('minsize="([%d.]+)" maxsize="[%d.]+" stretchy="false"', 'minsize="%1em" maxsize="%1em" stretchy="true"'))
end

-- A sign behind a relation, a comma or a parenthesis is that of a number, and stands close to it. One alone has no spaces.
local function with_signs(text)
  for _, sign in ipairs({"−", "±"}) do
    local close = '<mo form="prefix">' .. sign .. "</mo>"
    text = text:gsub("(<mo>([^<]*)</mo>)<mo>" .. sign .. "</mo>", function(before, relation)
      return ("= , : &lt; &gt; ≤ ≥ ≈ ≡ ≠ ∼ →"):find(relation, 1, true) and before .. close
    end)
    text = text:gsub('(form="prefix">[^<]*</mo>)<mo>' .. sign .. "</mo>", "%1" .. close)
  end
  return (text:gsub("^<mo>([^<]*)</mo>$", '<mo lspace="0em" rspace="0em">%1</mo>'))
end

-- Letters that TeX sets upright: those of \mathrm, as one word, and capital Greek ones.
local function with_upright_letters(text)
  text = text:gsub('<mstyle mathvariant="normal">(.-)</mstyle>', function(letters)
    return "<mrow>" .. letters:gsub("</mi><mi>", ""):gsub("<mi>", '<mi mathvariant="normal">') .. "</mrow>"
  end)
  return (text:gsub("<mi>(\xce[\x93-\xa9])</mi>", '<mi mathvariant="normal">%1</mi>'))
end

local function written(block)
  return pandoc.write(pandoc.Pandoc({block}), "html", {html_math_method = "mathml", wrap_text = "none"})
end

-- Formulas without the names that HTML does not need, and their TeX in an attribute. Rows of a display are as large as a display of
-- one line.
local function mathml(math)
  local body, tex = written(pandoc.Plain({math})):match("<semantics>(.*)<annotation[^>]*>(.*)</annotation>")
  if not body then
    io.stderr:write("formula: ", (math.text:gsub("%s+", " ")), "\n")
    return {}
  end
  for _, mend in ipairs({with_plain_fences, with_sizes, with_signs, with_upright_letters, with_operator_spaces}) do body = mend(body) end
  local is_display = math.mathtype == "DisplayMath"
  if is_display then body = body:gsub("^<mtable>", '<mtable displaystyle="true">') end
  return html(string.format('<math%s alttext="%s">%s</math>', is_display and ' display="block"' or "", tex:gsub('"', "&quot;"), body))
end

-- Lines of code with their numbers, and without links that nobody can name. One that is scrolled sideways can be reached by the
-- keyboard.
local function code(block)
  local text = written(block):gsub('<span id="cb%d+%-(%d+)"><a [^>]*></a>', '<span class="lit-line" data-line="%1">')
  return pandoc.RawBlock("html", (text:gsub(' id="cb%d+"', ""):gsub("<pre class=", '<pre tabindex="0" class=')))
end

return {
  {Div = block},
  {Link = inline},
  {RawInline = unknown, RawBlock = unknown, Table = native_table, Math = breakable},
  {Inlines = unbroken, Para = row_of_drawings, Plain = row_of_drawings},
  {Pandoc = function(doc)
    local listed = pandoc.BulletList(contents(pandoc.utils.make_sections(false, nil, doc.blocks)))
    local blocks = pandoc.List({pandoc.RawBlock("html", '<nav id="contents" aria-label="Contents">'), listed,
                                pandoc.RawBlock("html", '</nav>\n<main id="main">')})
    blocks:extend(doc.blocks)
    return pandoc.Pandoc(blocks, {})
  end},
  {Math = mathml, CodeBlock = code},
}
