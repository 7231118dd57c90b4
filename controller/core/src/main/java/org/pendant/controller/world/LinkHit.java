package org.pendant.controller.world;

/**
 * Link hit: a link of the arm that is in something.
 *
 * @param link which; of two links the one that is farther from the base
 * @param other what it is in: a link, or an object of the scene by its name
 * @param object whether that is an object
 * @param joint the joint that moves the link, 0 to 5
 * @param depthM how deep it is, m
 */
public record LinkHit(String link, String other, boolean object, int joint, double depthM) {
  /** Stands before links in {@link #sentence}, and not before objects. */
  public static final String THE = "the ";

  /** Stands between the two. */
  public static final String HAS_HIT = " has hit ";

  /** Who has hit what, as in {@code the forearm has hit "fixture"}. */
  public String sentence() {
    return THE + link + HAS_HIT + otherWords();
  }

  /** What it is in, as a sentence has it. */
  public String otherWords() {
    return object ? '"' + other + '"' : THE + other;
  }
}
