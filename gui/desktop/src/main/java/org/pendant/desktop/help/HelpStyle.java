package org.pendant.desktop.help;

import java.awt.Color;
import javax.swing.UIManager;
import javax.swing.text.html.HTMLEditorKit;
import javax.swing.text.html.StyleSheet;
import org.pendant.kit.theme.Palette;

/** Help style: pages in the colours and letters of the look. */
final class HelpStyle {
  private HelpStyle() {}

  /** What reads and shows a page, with the look that there is now. */
  static HTMLEditorKit kit() {
    StyleSheet style = new StyleSheet();
    style.addStyleSheet(new HTMLEditorKit().getStyleSheet());
    int size = UIManager.getFont("Label.font").getSize();
    String words = hex(UIManager.getColor("Label.foreground"));
    style.addRule(
        "body {font-family: "
            + UIManager.getFont("Label.font").getFamily()
            + "; font-size: "
            + size
            + "pt; color: "
            + words
            + "; margin: 12px}");
    style.addRule("h1 {font-size: " + (size * 3 / 2) + "pt; margin-top: 0}");
    style.addRule("h2 {font-size: " + (size * 5 / 4) + "pt; margin-top: " + size + "px}");
    style.addRule("h3 {font-size: " + size + "pt; margin-top: " + size + "px}");
    style.addRule("code, pre {font-family: JetBrains Mono; font-size: " + (size - 1) + "pt}");
    style.addRule(
        "pre {background-color: "
            + hex(UIManager.getColor("Panel.background"))
            + "; padding: 6px}");
    style.addRule("h1, h2, h3 {margin-bottom: 0}");
    style.addRule("pre, table {margin-top: 10px}");
    style.addRule("th, td {padding: 2px 16px 2px 0}");
    style.addRule("ul {margin-left: 18px}");
    style.addRule("a {color: " + hex(Palette.accent()) + "}");
    HTMLEditorKit kit = new HTMLEditorKit();
    kit.setStyleSheet(style);
    return kit;
  }

  private static String hex(Color color) {
    return String.format("#%06x", color.getRGB() & 0xFFFFFF);
  }
}
