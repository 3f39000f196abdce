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

local function unknown(raw)
  if raw.format ~= "latex" then return nil end
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

-- TeX breaks no line between a formula and what touches it; a browser would.
local function unbroken(inlines)
  local kept, run, has_formula = pandoc.List(), pandoc.List(), false
  local function add_run()
    local is_close = has_formula and #run > 1
    if is_close then kept:insert(html('<span class="lit-close">')) end
    kept:extend(run)
    if is_close then kept:insert(html("</span>")) end
    run, has_formula = pandoc.List(), false
  end
  for _, inline in ipairs(inlines) do
    if inline.t == "Str" or inline.t == "Math" then
      run:insert(inline)
      has_formula = has_formula or inline.t == "Math"
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

-- The contents: each heading without what is no text of it, the lower ones in a list within the one above. The end of an item
-- need not be said.
local function contents(doc)
  local items, depth, is_inner = pandoc.List(), 0, false
  local function add(text) items:insert(pandoc.RawBlock("html", text)) end
  doc:walk({Header = function(header)
    local text = header.content:walk({
      RawInline = function() return {} end,
      Note = function() return {} end,
      Link = function(link) return link.content end})
    local is_part = pandoc.utils.stringify(text):match("^Part") ~= nil
    local is_root = depth == 1 and header.level == 2
    depth = is_part and 1 or is_root and 0 or depth
    local is_lower = not is_part and header.level > 2 + depth
    if is_lower ~= is_inner then add(is_lower and "<ol>" or "</ol>") end
    is_inner = is_lower
    add(is_part and '<li class="lit-toc-part">' or is_root and '<li class="lit-toc-root">' or "<li>")
    items:insert(pandoc.Plain({pandoc.Link(text, "#" .. header.identifier)}))
  end})
  if is_inner then add("</ol>") end
  items:insert(1, pandoc.RawBlock("html", '<nav id="contents" aria-label="Contents"><ol>'))
  add('</ol></nav>\n<main id="main">')
  return items
end

return {
  {Div = block},
  {Link = inline},
  {RawInline = unknown, RawBlock = unknown, Table = native_table, Math = breakable},
  {Inlines = unbroken, Para = row_of_drawings, Plain = row_of_drawings},
  {Pandoc = function(doc)
    local blocks = contents(doc)
    blocks:extend(doc.blocks)
    return pandoc.Pandoc(blocks, {})
  end},
}
