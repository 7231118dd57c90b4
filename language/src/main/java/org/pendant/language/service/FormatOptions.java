package org.pendant.language.service;

/**
 * Format options: how {@link ScriptAnalysis#format} lays a text out.
 *
 * @param indentation blanks for each block, 1 to 16
 */
public record FormatOptions(int indentation) {
  /** Two blanks, as the manual prints programs. */
  public static final FormatOptions DEFAULT = new FormatOptions(2);

  public FormatOptions {
    if (indentation < 1 || indentation > 16) {
      throw new IllegalArgumentException(
          "indentation is " + indentation + " blanks, must be 1 to 16");
    }
  }
}
