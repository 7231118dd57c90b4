package org.pendant.project.installation.file;

/** Installation file error: a file that is no installation, or a wrong one. */
public final class InstallationTrouble extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * Something wrong with a file.
   *
   * @param message which file, where in it, what, and what would be right
   */
  InstallationTrouble(String message) {
    super(message);
  }
}
