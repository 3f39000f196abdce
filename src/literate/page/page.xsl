<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later
     LaTeXML's page with a main part, captions as alternative texts, and the entries of the ledger as cards. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform" xmlns:ltx="http://dlmf.nist.gov/LaTeXML"
    xmlns:m="http://www.w3.org/1998/Math/MathML" exclude-result-prefixes="ltx m">
  <xsl:import href="urn:x-LaTeXML:XSLT:LaTeXML-html5.xsl"/>

  <xsl:template match="/" mode="body-main">
    <main><xsl:apply-templates/></main>
  </xsl:template>
  <xsl:template match="/" mode="navbar">
    <nav class="contents" aria-label="Contents"><xsl:apply-templates select="//ltx:navigation/ltx:TOC/ltx:toclist"/></nav>
  </xsl:template>

  <xsl:template match="ltx:graphics">
    <img src="{substring-before(concat(@candidates, ','), ',')}" data-options="{@options}">
      <xsl:attribute name="alt">
        <xsl:variable name="text">
          <xsl:apply-templates select="ancestor::*[ltx:caption][1]/ltx:caption/node()" mode="plain"/>
        </xsl:variable>
        <!-- without invisible characters of formulas -->
        <xsl:value-of select="normalize-space(translate($text, '&#x2061;&#x2062;&#x2063;', ''))"/>
      </xsl:attribute>
    </img>
  </xsl:template>
  <xsl:template match="*" mode="plain"><xsl:apply-templates mode="plain"/></xsl:template>
  <xsl:template match="ltx:tag" mode="plain"/>
  <xsl:template match="ltx:text[contains(@class, 'claim')]" mode="plain"/>
  <xsl:template match="ltx:TOC//ltx:text[contains(@class, 'claim')]"/>

  <xsl:template name="dates">
    <xsl:param name="dates" select="ltx:date"/>
    <xsl:if test="normalize-space($dates)"><div class="ltx_dates"><xsl:apply-templates select="$dates/node()"/></div></xsl:if>
  </xsl:template>

  <!-- The head of a column is a <th> only if it has words: axe treats a head with nothing but a formula as empty. -->
  <xsl:template match="ltx:td[@thead]">
    <xsl:variable name="words" select=".//text()[normalize-space() and not(ancestor::m:math)]"/>
    <xsl:element name="{substring('thtd', 1 + 2 * not($words), 2)}">
      <xsl:attribute name="class">
        <xsl:value-of select="concat('ltx_align_', @align)"/>
        <xsl:if test="starts-with(normalize-space(.), '(')"> unit</xsl:if>
        <xsl:if test="contains(@border, 't')"> ltx_border_t</xsl:if>
        <xsl:if test="contains(@border, 'b')"> ltx_border_b</xsl:if>
      </xsl:attribute>
      <xsl:copy-of select="@colspan | @rowspan"/>
      <xsl:apply-templates/>
    </xsl:element>
  </xsl:template>

  <!-- The verdict beside a claim opens the claim's card, which is its entry in the ledger. Browsers that have no cards follow the
       link beside it. -->
  <xsl:template match="ltx:text[contains(@class, 'verdict')]">
    <span class="verdict" data-verdict="{.}"><xsl:apply-templates/></span>
  </xsl:template>
  <xsl:template match="ltx:text[contains(@class, 'claim') and ltx:ref/@href]/ltx:text[contains(@class, 'verdict')]">
    <button type="button" class="verdict" data-verdict="{.}" popovertarget="{../ltx:ref/@idref}"
        aria-label="{../ltx:ref} {.}"><xsl:apply-templates/></button>
  </xsl:template>
  <xsl:template match="ltx:theorem[contains(@class, 'entry')]">
    <article class="entry" id="{@xml:id}" popover="auto">
      <button type="button" class="close" popovertarget="{@xml:id}" popovertargetaction="hide">close</button>
      <xsl:apply-templates/>
    </article>
  </xsl:template>
</xsl:stylesheet>
