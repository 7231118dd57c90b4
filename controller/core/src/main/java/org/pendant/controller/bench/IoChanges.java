package org.pendant.controller.bench;

import static org.pendant.controller.bench.BenchTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.SignalBank;

/** Changes of digital signals since the start of a test, in their order. */
public final class IoChanges {
  /** Changes that are kept; of more, the oldest go. */
  public static final int MAX_KEPT = 10_000;

  private static final int MAX_TOLD = 20;

  private final List<Change> changes = new ArrayList<>();
  private DigitalLevels last = DigitalLevels.ALL_LOW;
  private boolean begun;

  /** One change. */
  private record Change(String name, double timeS) {}

  IoChanges() {}

  /** Takes the levels at the end of a frame; the first ones are no change. */
  public void see(DigitalLevels levels, double timeS) {
    if (begun && !levels.equals(last)) {
      for (SignalBank bank : SignalBank.values()) {
        int now = levels.bits(bank);
        int changed = now ^ last.bits(bank);
        for (int i = 0; changed != 0 && i < bank.size(); i++) {
          if ((changed >> i & 1) != 0) {
            add(new Change(name(bank, i) + ((now >> i & 1) != 0 ? " on" : " off"), timeS));
          }
        }
      }
    }
    begun = true;
    last = levels;
  }

  private void add(Change change) {
    if (changes.size() == MAX_KEPT) {
      changes.removeFirst();
    }
    changes.add(change);
  }

  private static String name(SignalBank bank, int index) {
    String prefix =
        switch (bank) {
          case STANDARD_IN -> "DI";
          case STANDARD_OUT -> "DO";
          case CONFIGURABLE_IN -> "CI";
          case CONFIGURABLE_OUT -> "CO";
          case TOOL_IN -> "TI";
          case TOOL_OUT -> "TO";
          case FLAG -> "flag ";
        };
    return prefix + index;
  }

  /**
   * How many of some changes came about in this order, others between them or not.
   *
   * @param wanted such as {@code DO0 on}, in capitals or not
   */
  public int inOrder(List<String> wanted) {
    int found = 0;
    for (Change each : changes) {
      if (found < wanted.size()
          && each.name()
              .toLowerCase(Locale.ROOT)
              .equals(wanted.get(found).strip().toLowerCase(Locale.ROOT))) {
        found++;
      }
    }
    return found;
  }

  /** The last changes with their times, for people. */
  public String told() {
    if (changes.isEmpty()) {
      return text("nothingChanged");
    }
    StringBuilder text = new StringBuilder();
    int from = Math.max(0, changes.size() - MAX_TOLD);
    for (Change each : changes.subList(from, changes.size())) {
      text.append(text.isEmpty() ? from > 0 ? "..., " : "" : ", ")
          .append(each.name())
          .append(String.format(Locale.ROOT, " at %.3f s", each.timeS()));
    }
    return text.toString();
  }
}
