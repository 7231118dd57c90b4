package org.pendant.kit.dock;

import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.kit.layout.WindowBounds;
import org.pendant.kit.settings.Settings;

/**
 * Dock plan: which view is where, which one is in front, and how large the docks are. A view is at
 * the same side on every screen; which is in front, how large the docks are and which are folded is
 * remembered for each screen. Every change is remembered in the settings; what they name and is not
 * there is left out, what they do not name is where it belongs at first.
 */
public final class DockPlan {
  /** Smallest size of a dock, in pixels before scaling. */
  static final int SMALLEST = 120;

  private static final double MIN_SHARE = 0.05;
  private static final double MAX_SHARE = 0.9;

  private static final String SCREEN = "dock.screen";

  private final Settings settings;
  private final Set<String> wide;
  private final Map<Side, List<String>> views = new EnumMap<>(Side.class);
  private String screen = "";

  /**
   * The plan that was left last time.
   *
   * @param home where each view belongs at first, in the order of the views
   * @param wide the screens that share the width evenly with the docks at the right at first
   */
  public DockPlan(Settings settings, Map<String, Side> home, Set<String> wide) {
    this.settings = settings;
    this.wide = Set.copyOf(wide);
    for (Side side : Side.values()) {
      views.put(side, new ArrayList<>());
      for (String id : words(settings.get(viewsName(side)).orElse(""))) {
        if (home.containsKey(id) && !placed(id)) {
          views.get(side).add(id);
        }
      }
    }
    home.forEach(
        (id, side) -> {
          if (!placed(id)) {
            views.get(side).add(id);
          }
        });
    screen = settings.get(SCREEN).orElse("");
  }

  private static List<String> words(String text) {
    return Arrays.stream(text.split(" ")).filter(word -> !word.isEmpty()).toList();
  }

  private boolean placed(String id) {
    return views.values().stream().anyMatch(each -> each.contains(id));
  }

  private static String viewsName(Side side) {
    return "dock." + side.word() + ".views";
  }

  /** What is remembered for the screen in the main area. */
  private Optional<String> remembered(Side side, String what) {
    return settings.get(name(side, what)).filter(text -> !text.isEmpty());
  }

  private void remember(Side side, String what, String text) {
    settings.put(name(side, what), text);
  }

  private String name(Side side, String what) {
    return name(selected(Side.MAIN).orElse("none"), side, what);
  }

  private static String name(String screen, Side side, String what) {
    return "dock." + screen + "." + side.word() + "." + what;
  }

  /** The views on a side, in the order of their tabs. */
  public List<String> views(Side side) {
    return List.copyOf(views.get(side));
  }

  /** Where a view is; empty for one that is not there. */
  public Optional<Side> sideOf(String id) {
    return Arrays.stream(Side.values()).filter(side -> views.get(side).contains(id)).findFirst();
  }

  /** The view in front on a side; empty where there is none. */
  public Optional<String> selected(Side side) {
    List<String> there = views.get(side);
    return (side == Side.MAIN ? Optional.of(screen) : remembered(side, "selected"))
        .filter(there::contains)
        .or(() -> there.stream().findFirst());
  }

  /** Brings a view to the front of its side. */
  public void select(String id) {
    sideOf(id)
        .ifPresent(
            side -> {
              if (side == Side.MAIN) {
                screen = id;
                settings.put(SCREEN, id);
              } else if (side != Side.WINDOW) {
                remember(side, "selected", id);
              }
            });
  }

  /** Moves a view to the end of a side, in front of the others there. */
  public void move(String id, Side to) {
    move(id, to, Integer.MAX_VALUE);
  }

  /**
   * Moves a view, in front of the others there.
   *
   * @param index of its tab there, from 0; the last place if there are fewer
   */
  public void move(String id, Side to, int index) {
    Optional<Side> from = sideOf(id);
    if (from.isEmpty()) {
      return;
    }
    if (to == Side.WINDOW && from.get() != Side.WINDOW) {
      settings.put(windowName(id, "from"), from.get().word());
    }
    views.get(from.get()).remove(id);
    List<String> there = views.get(to);
    there.add(Math.clamp(index, 0, there.size()), id);
    remember(from.get());
    remember(to);
    select(id);
    setCollapsed(to, false);
  }

  /** Moves a view from a window of its own to the side where it was before. */
  public void putBack(String id) {
    String from = settings.get(windowName(id, "from")).orElse("");
    move(
        id,
        Arrays.stream(Side.values())
            .filter(side -> side != Side.WINDOW && side.word().equals(from))
            .findFirst()
            .orElse(Side.RIGHT));
  }

  /** Where the window of a view was the last time, in pixels; empty if it had none. */
  Optional<Rectangle> windowBounds(String id) {
    return WindowBounds.parse(settings.get(windowName(id, "bounds")).orElse(""));
  }

  /** Remembers where the window of a view is, in pixels. */
  void setWindowBounds(String id, Rectangle bounds) {
    settings.put(windowName(id, "bounds"), WindowBounds.format(bounds));
  }

  private static String windowName(String id, String what) {
    return "dock.window." + id + "." + what;
  }

  private void remember(Side side) {
    settings.put(viewsName(side), String.join(" ", views.get(side)));
  }

  /**
   * Whether only the tabs of a side are shown; never so for the main area and for windows. The
   * lower right one is folded with the right one above it.
   */
  public boolean collapsed(Side side) {
    if (side == Side.MAIN || side == Side.WINDOW) {
      return false;
    }
    boolean folded =
        remembered(side, "collapsed").map(Boolean::parseBoolean).orElse(side == Side.BOTTOM);
    return folded || (side == Side.LOWER && collapsed(Side.RIGHT));
  }

  /** Shows only the tabs of a side, as with the bottom at first, or all of it. */
  public void setCollapsed(Side side, boolean collapsed) {
    if (side != Side.MAIN && side != Side.WINDOW) {
      remember(side, "collapsed", Boolean.toString(collapsed));
    }
    if (side == Side.LOWER && !collapsed) {
      setCollapsed(Side.RIGHT, false);
    }
  }

  /**
   * How much of the window's width a side takes, or of its height; of the lower right one, how much
   * of the height of both at the right. 0.05 to 0.9.
   */
  public double share(Side side) {
    try {
      double share = Integer.parseInt(remembered(side, "share").orElse("")) / 1000.0;
      return Math.clamp(share, MIN_SHARE, MAX_SHARE);
    } catch (NumberFormatException e) {
      return usualShare(side);
    }
  }

  private double usualShare(Side side) {
    return switch (side) {
      case MAIN, WINDOW -> 1;
      case LEFT -> 0.25;
      case RIGHT -> selected(Side.MAIN).filter(wide::contains).isPresent() ? 0.46 : 0.34;
      case LOWER -> 0.42;
      case BOTTOM -> 0.28;
    };
  }

  /** Changes the share of a side. */
  public void setShare(Side side, double share) {
    remember(
        side, "share", Long.toString(Math.round(1000 * Math.clamp(share, MIN_SHARE, MAX_SHARE))));
  }

  /** Puts everything where it belongs at first, on all screens. */
  public void reset(Map<String, Side> home) {
    views.values().forEach(List::clear);
    home.forEach((id, side) -> views.get(side).add(id));
    for (Side side : Side.values()) {
      remember(side);
      for (String each : home.keySet()) {
        for (String what : List.of("share", "selected", "collapsed")) {
          if (settings.get(name(each, side, what)).isPresent()) {
            settings.put(name(each, side, what), "");
          }
        }
      }
    }
  }
}
