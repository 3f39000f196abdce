// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

/// A PDF of one page with these text operators and, unless it is empty, an attachment coded in
/// hexadecimal.
inline std::string small_pdf(const std::string& text, const std::string& attachment = "") {
  std::string hexadecimal;
  for (const char c : attachment) {  // all of them ASCII
    hexadecimal += {"0123456789abcdef"[c / 16], "0123456789abcdef"[c % 16]};
  }
  const auto stream = [](const std::string& entries, const std::string& body) {
    return "<< " + entries + " /Length " + std::to_string(body.size()) + " >>\nstream\n" + body +
           "\nendstream";
  };
  const std::string names = " /Names << /EmbeddedFiles << /Names [(a.txt) 6 0 R] >> >>";
  const std::vector<std::string> objects = {
      "<< /Type /Catalog /Pages 2 0 R" + (attachment.empty() ? "" : names) + " >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 600 400] /Contents 4 0 R\n"
      "/Resources << /Font << /F << /Type /Font /Subtype /Type1 /BaseFont /Courier >> >> >> >>",
      stream("", "BT /F 10 Tf 20 300 Td " + text + " ET"),
      stream("/Type /EmbeddedFile /Filter /ASCIIHexDecode", hexadecimal + ">"),
      "<< /Type /Filespec /F (a.txt) /EF << /F 5 0 R >> >>"};
  std::string pdf = "%PDF-1.4\n", places = "0000000000 65535 f \n";
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string place = std::to_string(pdf.size());
    places += std::string(10 - place.size(), '0') + place + " 00000 n \n";
    pdf += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
  }
  const std::string end = std::to_string(pdf.size());
  return pdf + "xref\n0 7\n" + places + "trailer << /Size 7 /Root 1 0 R >>\nstartxref\n" + end +
         "\n%%EOF\n";
}
