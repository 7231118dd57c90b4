package org.pendant.command;

import org.pendant.models.arm.Confidence;

/**
 * Trust: how far one group of an arm's numbers can be trusted.
 *
 * @param group the group, such as {@code masses}
 * @param confidence of all its numbers
 */
record Trust(String group, Confidence confidence) {

  /** What {@code confidence} means, in a few words. */
  static String meaning(Confidence confidence) {
    return switch (confidence) {
      case VERIFIED -> "two independent public sources agree";
      case MEASURED -> "measured on a public 3D drawing of this arm";
      case ASSUMED -> "taken over from a sister model";
      case ESTIMATED -> "an estimate";
      case MISSING -> "not known";
    };
  }
}
