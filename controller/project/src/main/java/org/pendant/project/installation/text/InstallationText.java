package org.pendant.project.installation.text;

import org.pendant.controller.installation.Installation;

/**
 * Installation text: a heading, then one thing a line, in an order that never changes. The same
 * installation always gives the same text, and reading it gives the same installation, to the last
 * digit of every number. docs/installations.md describes the lines.
 */
public final class InstallationText {
  /** Ending of the names of such files. */
  public static final String ENDING = ".pinst";

  /** With what every such text begins. */
  static final String HEADING = "pendant installation 1";

  private InstallationText() {}

  /** The text of an installation; lines end with a line feed. */
  public static String write(Installation installation) {
    return new InstallationWriter().write(installation);
  }

  /** Reads an installation; what is left out is as in {@link Installation#NONE}. */
  public static ReadInstallation read(String text) {
    InstallationReading reading = new InstallationReading(text);
    return new ReadInstallation(reading.installation(), reading.problems());
  }
}
