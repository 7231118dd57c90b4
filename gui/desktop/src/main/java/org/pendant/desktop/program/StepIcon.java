package org.pendant.desktop.program;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.Step;

/** Step icon: a small drawing for each kind of node, in the colour of its family. */
final class StepIcon {
  /** Of its sides, in pixels before scaling. */
  static final int SIDE = 16;

  private static final Map<NodeKind, SvgIcon> ICONS =
      Arrays.stream(NodeKind.values())
          .collect(
              Collectors.toUnmodifiableMap(
                  Function.identity(), kind -> SvgIcon.of("node/" + drawing(kind), SIDE)));

  private StepIcon() {}

  static SvgIcon of(Step step) {
    return of(NodeKind.of(step));
  }

  static SvgIcon of(NodeKind kind) {
    return ICONS.get(kind);
  }

  private static String drawing(NodeKind kind) {
    return switch (kind) {
      case SUB_PROGRAM -> "call";
      case DEFAULT_CASE -> "case";
      case PART_BEFORE, PART_AFTER, PART_SEQUENCE -> "part";
      default -> kind.name().toLowerCase(Locale.ROOT).replace('_', '-');
    };
  }
}
