package org.pendant.controller.world;

import static org.pendant.controller.world.WorldTexts.text;

import java.util.Optional;

/**
 * Link hit: a link of the arm that is in something.
 *
 * @param link which; of two links of the arm the one that is farther from the base
 * @param other what it is in: a link, or an object of the scene by its name
 * @param object whether that is an object
 * @param otherArm the arm whose link it is in; empty for one of its own, and for an object
 * @param joint the joint that moves the link, 0 to 5; 0 for the base, which another arm got into
 * @param depthM how deep it is, m
 */
public record LinkHit(
    String link,
    String other,
    boolean object,
    Optional<String> otherArm,
    int joint,
    double depthM) {
  /** Stands before links in {@link #sentence}, and not before objects. */
  public static final String THE = "the ";

  /** Stands between the two. */
  public static final String HAS_HIT = " has hit ";

  /** Stands between the link of another arm and the name of that arm. */
  public static final String OF = " of ";

  /** Who has hit what, as in {@code the forearm has hit "fixture"}. */
  public String sentence() {
    if (object) {
      return text("linkHitObject", link, other);
    }
    return otherArm
        .map(arm -> text("linkHitOtherArm", link, other, arm))
        .orElseGet(() -> text("linkHitLink", link, other));
  }

  /** What it is in, as a sentence has it. */
  public String otherWords() {
    return object ? '"' + other + '"' : THE + other + otherArm.map(arm -> OF + arm).orElse("");
  }
}
