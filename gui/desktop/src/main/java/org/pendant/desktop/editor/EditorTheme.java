package org.pendant.desktop.editor;

import com.formdev.flatlaf.fonts.jetbrains_mono.FlatJetBrainsMonoFont;
import com.formdev.flatlaf.util.FontUtils;
import java.awt.Color;
import java.awt.Font;
import javax.swing.UIManager;
import org.fife.ui.rsyntaxtextarea.Style;
import org.fife.ui.rsyntaxtextarea.SyntaxScheme;
import org.fife.ui.rtextarea.ExpandedFoldRenderStrategy;
import org.fife.ui.rtextarea.Gutter;
import org.fife.ui.rtextarea.RTextScrollPane;
import org.pendant.kit.theme.Palette;
import org.pendant.language.service.HighlightToken;

/** Editor theme: dresses text components in the colours and the font of the current theme. */
final class EditorTheme {
  private EditorTheme() {}

  /**
   * JetBrains Mono at the size of the window's font, and other fonts for letters that it does not
   * have, such as Chinese ones. Java keeps one width of a letter for all fonts of a name and size,
   * so other texts in this font would be broken into lines by wrong widths if it were without.
   */
  static Font codeFont() {
    Font font = UIManager.getFont("defaultFont");
    int size = font == null ? 13 : font.getSize();
    // The family may be installed without having been read yet.
    FontUtils.loadFontFamily(FlatJetBrainsMonoFont.FAMILY);
    return FontUtils.getCompositeFont(FlatJetBrainsMonoFont.FAMILY, Font.PLAIN, size);
  }

  static void apply(ScriptArea area, RTextScrollPane pane) {
    EditorColors colors = EditorColors.now();
    Font font = codeFont().deriveFont(codeFont().getSize2D() + area.zoom());
    area.setFont(font);
    area.setSyntaxScheme(scheme(colors, font));
    area.setBackground(colors.background());
    area.setForeground(colors.text());
    area.setCaretColor(Palette.accent());
    area.setSelectionColor(colors.selection());
    area.setUseSelectedTextColor(false);
    area.setCurrentLineHighlightColor(colors.currentLine());
    area.setMatchedBracketBGColor(colors.bracket());
    area.setMatchedBracketBorderColor(Palette.accent());
    area.setMarkAllHighlightColor(colors.match());
    area.setMarkOccurrencesColor(colors.bracket());
    area.setTabLineColor(colors.gutterLine());
    area.setHyperlinkForeground(Palette.accent());
    apply(pane.getGutter(), colors, font);
    pane.getViewport().setBackground(colors.background());
  }

  private static void apply(Gutter gutter, EditorColors colors, Font font) {
    gutter.setBackground(colors.background());
    gutter.setBorderColor(colors.gutterLine());
    gutter.setLineNumberColor(colors.lineNumber());
    gutter.setCurrentLineNumberColor(colors.text());
    gutter.setLineNumberFont(font);
    gutter.setFoldBackground(colors.background());
    gutter.setArmedFoldBackground(colors.background());
    gutter.setFoldIndicatorBackground(colors.background());
    gutter.setFoldIndicatorForeground(colors.lineNumber());
    gutter.setFoldIndicatorArmedForeground(Palette.accent());
    gutter.setIconRowHeaderInheritsGutterBackground(true);
    gutter.setExpandedFoldRenderStrategy(ExpandedFoldRenderStrategy.ALWAYS);
  }

  private static SyntaxScheme scheme(EditorColors colors, Font font) {
    SyntaxScheme scheme = new SyntaxScheme(font, false);
    for (int i = 0; i < scheme.getStyleCount(); i++) {
      scheme.setStyle(i, style(colors.text(), font));
    }
    for (HighlightToken.Style each : HighlightToken.Style.values()) {
      boolean strong = each == HighlightToken.Style.KEYWORD;
      scheme.setStyle(
          ScriptTokenMaker.type(each),
          style(colors.of(each), strong ? font.deriveFont(Font.BOLD) : font));
    }
    return scheme;
  }

  private static Style style(Color color, Font font) {
    return new Style(color, null, font);
  }
}
