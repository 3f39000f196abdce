<?xml version="1.0" encoding="utf-8"?>
<!-- SPDX-License-Identifier: GPL-3.0-or-later
     LaTeXML's page, with contents in front, captions as the figures' alternative text, and boxes that scroll. -->
<xsl:stylesheet version="1.0" xmlns:xsl="http://www.w3.org/1999/XSL/Transform"
    xmlns:ltx="http://dlmf.nist.gov/LaTeXML" xmlns:m="http://www.w3.org/1998/Math/MathML"
    exclude-result-prefixes="ltx m">
  <xsl:import href="urn:x-LaTeXML:XSLT:LaTeXML-html5.xsl"/>

  <xsl:template match="/" mode="footer"/>

  <xsl:template match="ltx:graphics">
    <img class="figure" src="{@graphic}">
      <xsl:attribute name="alt">
        <xsl:variable name="text">
          <xsl:apply-templates select="ancestor::ltx:figure[1]/ltx:caption/node()" mode="plain"/>
        </xsl:variable>
        <xsl:value-of select="normalize-space($text)"/>
      </xsl:attribute>
    </img>
  </xsl:template>
  <xsl:template match="text()" mode="plain"><xsl:value-of select="."/></xsl:template>
  <xsl:template match="*" mode="plain"><xsl:apply-templates mode="plain"/></xsl:template>
  <xsl:template match="ltx:XMath | m:annotation | m:annotation-xml | ltx:tag" mode="plain"/>

  <xsl:template match="ltx:tabular | ltx:listing">
    <div class="scrolls" tabindex="0"><xsl:apply-imports/></div>
  </xsl:template>
  <xsl:template match="ltx:equationgroup | ltx:equation[not(ancestor::ltx:equationgroup)]">
    <div class="scrolls"><xsl:apply-imports/></div>
  </xsl:template>

  <xsl:template match="ltx:section[not(preceding::ltx:section)]">
    <details class="contents">
      <summary>Contents</summary>
      <ol>
        <xsl:for-each select="//ltx:section | //ltx:appendix | //ltx:bibliography">
          <li>
            <span><xsl:value-of select="ltx:tags/ltx:tag[@role='refnum']"/></span>
            <xsl:text> </xsl:text>
            <a href="#{@xml:id}"><xsl:apply-templates select="ltx:title/node()[not(self::ltx:tag)]"/></a>
          </li>
        </xsl:for-each>
      </ol>
    </details>
    <xsl:apply-imports/>
  </xsl:template>
</xsl:stylesheet>
