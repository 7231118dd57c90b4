package org.pendant.text;

/**
 * Bundles as code, which a start reads faster than files. The build has none; in jars that shall
 * start fast {@code .build/StartableJars.java} puts a class in place of this one that has those of
 * all modules, and takes their files away.
 */
final class CompiledTexts {
  private static final String[] NONE = {};

  private CompiledTexts() {}

  /**
   * The texts of a bundle, a key before each; empty if they are in a file, or nowhere.
   *
   * @param bundle such as {@code desktop.sweep_de}
   */
  static String[] of(@SuppressWarnings("unused") String bundle) {
    return NONE;
  }
}
