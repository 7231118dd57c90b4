package org.pendant.desktop.shell.chrome;

import static org.pendant.desktop.shell.chrome.ChromeTexts.text;

import java.math.BigDecimal;
import java.util.List;
import org.pendant.controller.Pace;

/**
 * Pace choice: a pace that people can choose.
 *
 * @param title such as {@code x 2}
 */
public record PaceChoice(String title, Pace pace) {
  /** Slowest first. */
  public static final List<PaceChoice> ALL =
      List.of(
          new PaceChoice(text("paused"), new Pace.Paused()),
          new PaceChoice("x 0.1", new Pace.Times(0.1)),
          new PaceChoice("x 0.5", new Pace.Times(0.5)),
          new PaceChoice(text("realTime"), Pace.REAL_TIME),
          new PaceChoice("x 2", new Pace.Times(2)),
          new PaceChoice("x 5", new Pace.Times(5)),
          new PaceChoice("x 10", new Pace.Times(10)),
          new PaceChoice(text("asFastAsPossible"), new Pace.Unlimited()));

  /** The choice for a pace; one that cannot be chosen shows its factor. */
  public static PaceChoice of(Pace pace) {
    return ALL.stream()
        .filter(each -> each.pace().equals(pace))
        .findFirst()
        .orElseGet(() -> new PaceChoice(title(pace), pace));
  }

  private static String title(Pace pace) {
    return switch (pace) {
      case Pace.Paused() -> text("paused");
      case Pace.Times(double factor) -> "x " + BigDecimal.valueOf(factor).stripTrailingZeros();
      case Pace.Unlimited() -> text("asFastAsPossible");
    };
  }

  /** The pace {@code steps} places faster, or slower if negative, without pausing. */
  public static Pace faster(Pace pace, int steps) {
    int index = ALL.indexOf(of(pace));
    return ALL.get(Math.clamp(index + steps, 1, ALL.size() - 1)).pace();
  }

  @Override
  public String toString() {
    return title;
  }
}
