package org.pendant.command;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.models.arm.Confidence;

/**
 * Trust: how far one group of an arm's numbers can be trusted.
 *
 * @param group the group, such as {@code masses}
 * @param confidences of its numbers, each once
 */
record Trust(String group, List<Confidence> confidences) {
  Trust {
    confidences = List.copyOf(confidences);
  }

  /** All numbers of a group have the same confidence. */
  Trust(String group, Confidence confidence) {
    this(group, List.of(confidence));
  }

  /** The numbers of a group, base first; what is surest is named first. */
  static Trust ofJoints(String group, Stream<Confidence> confidences) {
    return new Trust(group, confidences.distinct().sorted().toList());
  }

  /** What the group is: {@code measured}, or {@code measured, derived}. */
  String words() {
    return confidences.stream().map(Confidence::word).collect(Collectors.joining(", "));
  }

  /** Whether all numbers were taken from this very model. */
  boolean ofThisModel() {
    return confidences.stream().allMatch(Confidence::ofThisModel);
  }

  /** What {@link #words} mean; if they are several, where they are told apart. */
  String meanings() {
    return confidences.size() == 1 ? meaning(confidences.getFirst()) : "joint by joint, see above";
  }

  /** The confidences that occur in {@code groups}, the surest first. */
  static List<Confidence> occurring(List<Trust> groups) {
    return Arrays.stream(Confidence.values())
        .filter(each -> groups.stream().anyMatch(trust -> trust.confidences().contains(each)))
        .toList();
  }

  /** What {@code confidence} means, in a few words. */
  static String meaning(Confidence confidence) {
    return switch (confidence) {
      case VERIFIED -> "two independent public sources agree";
      case MEASURED -> "measured on a public 3D drawing or recording of this arm";
      case DERIVED -> "measured on another joint of the same size";
      case ASSUMED -> "taken over from a sister model";
      case ESTIMATED -> "an estimate";
      case MISSING -> "not known";
    };
  }
}
