package org.pendant.kit.theme;

/** Markup: plain texts in the HTML that Swing shows. */
public final class Markup {
  private static final int MAX_CHARACTERS = 2000;
  private static final String WRAPPED = "<html><body style=\"width: 320px\">";

  private Markup() {}

  /** The text as it is, whatever it contains. */
  public static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }

  /** A tool tip with the text on as many lines as it needs; one that is very long is cut. */
  public static String toolTip(String text) {
    String shown =
        text.length() > MAX_CHARACTERS ? text.substring(0, MAX_CHARACTERS) + "\u2026" : text;
    return WRAPPED + escaped(shown).replace("\n", "<br>");
  }
}
