package org.pendant.desktop.log;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.ToIntFunction;
import java.util.stream.Collectors;
import org.pendant.kit.settings.Settings;

/**
 * Column choice: which columns there are: those that people want, less some where the message would
 * have no room.
 */
final class LogColumns {
  private static final String KEY = "log.hidden-columns";
  private static final String HIDDEN_AT_FIRST = "wall_time";

  /** What goes first where there is little room. */
  private static final List<LogColumn> DISPENSABLE =
      List.of(LogColumn.THREAD, LogColumn.WALL_TIME, LogColumn.SOURCE, LogColumn.CODE);

  private final Settings settings;
  private final Set<LogColumn> hidden = EnumSet.noneOf(LogColumn.class);

  /**
   * A column as it is laid out.
   *
   * @param width in pixels
   * @param compact whether only a symbol fits
   */
  record Shown(LogColumn column, int width, boolean compact) {}

  LogColumns(Settings settings) {
    this.settings = settings;
    List<String> names = Arrays.asList(settings.get(KEY).orElse(HIDDEN_AT_FIRST).split(",", -1));
    for (LogColumn each : LogColumn.values()) {
      if (each.optional() && names.contains(name(each))) {
        hidden.add(each);
      }
    }
  }

  private static String name(LogColumn column) {
    return column.name().toLowerCase(Locale.ROOT);
  }

  /** Whether people want to see it. */
  boolean wanted(LogColumn column) {
    return !hidden.contains(column);
  }

  /** Shows or hides one that is optional, also after the next start. */
  void want(LogColumn column, boolean shown) {
    if (shown) {
      hidden.remove(column);
    } else {
      hidden.add(column);
    }
    settings.put(KEY, hidden.stream().map(LogColumns::name).collect(Collectors.joining(",")));
  }

  /**
   * The columns, and how wide they are; the message gets what is left.
   *
   * @param width of all, in pixels
   * @param leastMessage what the message needs, in pixels; where others cannot make room, it gets a
   *     third of it at least
   * @param widths of columns but the message, in pixels
   * @param compactSeverity width of the severity as a symbol, in pixels
   */
  List<Shown> fit(
      int width, int leastMessage, ToIntFunction<LogColumn> widths, int compactSeverity) {
    Set<LogColumn> shown = EnumSet.complementOf(EnumSet.copyOf(hiddenOrNone()));
    boolean compact = false;
    for (int dropped = -1; dropped < DISPENSABLE.size(); dropped++) {
      if (dropped >= 0) {
        shown.remove(DISPENSABLE.get(dropped));
      }
      // the word beside the symbol says nothing new
      compact = dropped >= 0;
      if (left(width, shown, widths, compact, compactSeverity) >= leastMessage) {
        break;
      }
    }
    List<Shown> laidOut = new ArrayList<>();
    for (LogColumn each : shown) {
      boolean symbol = compact && each == LogColumn.SEVERITY;
      int own =
          each == LogColumn.MESSAGE
              ? Math.max(leastMessage / 3, left(width, shown, widths, compact, compactSeverity))
              : symbol ? compactSeverity : widths.applyAsInt(each);
      laidOut.add(new Shown(each, own, symbol));
    }
    return laidOut;
  }

  private Set<LogColumn> hiddenOrNone() {
    Set<LogColumn> copy = EnumSet.noneOf(LogColumn.class);
    copy.addAll(hidden);
    return copy;
  }

  private static int left(
      int width,
      Set<LogColumn> shown,
      ToIntFunction<LogColumn> widths,
      boolean compact,
      int compactSeverity) {
    int used = 0;
    for (LogColumn each : shown) {
      if (each != LogColumn.MESSAGE) {
        used += compact && each == LogColumn.SEVERITY ? compactSeverity : widths.applyAsInt(each);
      }
    }
    return width - used;
  }
}
