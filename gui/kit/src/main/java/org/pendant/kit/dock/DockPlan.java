package org.pendant.kit.dock;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.kit.settings.Settings;

/**
 * Dock plan: which view is where, which one is in front, and how large the docks are. Every change
 * is remembered in the settings; what they name and is not there is left out, what they do not name
 * is where it belongs at first.
 */
public final class DockPlan {
  /** Smallest size of a dock, in pixels before scaling. */
  static final int SMALLEST = 120;

  private static final int LARGEST = 4000;

  private final Settings settings;
  private final Map<Side, List<String>> views = new EnumMap<>(Side.class);
  private final Map<Side, String> selected = new EnumMap<>(Side.class);

  /**
   * The plan that was left last time.
   *
   * @param home where each view belongs at first, in the order of the views
   */
  public DockPlan(Settings settings, Map<String, Side> home) {
    this.settings = settings;
    for (Side side : Side.values()) {
      views.put(side, new ArrayList<>());
      for (String id : words(settings.get(name(side, "views")).orElse(""))) {
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
    for (Side side : Side.values()) {
      settings
          .get(name(side, "selected"))
          .filter(views.get(side)::contains)
          .ifPresent(id -> selected.put(side, id));
    }
  }

  private static List<String> words(String text) {
    return Arrays.stream(text.split(" ")).filter(word -> !word.isEmpty()).toList();
  }

  private boolean placed(String id) {
    return views.values().stream().anyMatch(each -> each.contains(id));
  }

  private static String name(Side side, String what) {
    return "dock." + side.word() + "." + what;
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
    return Optional.ofNullable(selected.get(side))
        .filter(there::contains)
        .or(() -> there.stream().findFirst());
  }

  /** Brings a view to the front of its side. */
  public void select(String id) {
    sideOf(id)
        .ifPresent(
            side -> {
              selected.put(side, id);
              settings.put(name(side, "selected"), id);
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
    views.get(from.get()).remove(id);
    List<String> there = views.get(to);
    there.add(Math.clamp(index, 0, there.size()), id);
    remember(from.get());
    remember(to);
    select(id);
    setCollapsed(to, false);
  }

  private void remember(Side side) {
    settings.put(name(side, "views"), String.join(" ", views.get(side)));
  }

  /** Whether only the tabs of a side are shown; never so for the main area. */
  public boolean collapsed(Side side) {
    Optional<String> remembered = settings.get(name(side, "collapsed")).filter(t -> !t.isEmpty());
    return side != Side.MAIN && remembered.map(Boolean::parseBoolean).orElse(side == Side.BOTTOM);
  }

  /** Shows only the tabs of a side, as with the bottom at first, or all of it. */
  public void setCollapsed(Side side, boolean collapsed) {
    if (side != Side.MAIN) {
      settings.put(name(side, "collapsed"), Boolean.toString(collapsed));
    }
  }

  /** Width of a side, or height of the bottom, in pixels before scaling. */
  public int size(Side side) {
    int usual = side == Side.BOTTOM ? 200 : 420;
    try {
      int size = Integer.parseInt(settings.get(name(side, "size")).orElse(""));
      return Math.clamp(size, SMALLEST, LARGEST);
    } catch (NumberFormatException e) {
      return usual;
    }
  }

  /** Changes the size of a side. */
  public void setSize(Side side, int size) {
    settings.put(name(side, "size"), Integer.toString(Math.clamp(size, SMALLEST, LARGEST)));
  }

  /** Puts everything where it belongs at first. */
  public void reset(Map<String, Side> home) {
    views.values().forEach(List::clear);
    home.forEach((id, side) -> views.get(side).add(id));
    selected.clear();
    for (Side side : Side.values()) {
      remember(side);
      settings.put(name(side, "size"), "");
      settings.put(name(side, "selected"), "");
      settings.put(name(side, "collapsed"), "");
    }
  }
}
