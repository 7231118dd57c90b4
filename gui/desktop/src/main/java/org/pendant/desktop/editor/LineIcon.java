package org.pendant.desktop.editor;

import java.awt.Component;
import java.awt.Graphics;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.Icon;
import org.pendant.kit.icon.SvgIcon;

/**
 * Line icon: what stands beside one line, a breakpoint, the place where the program is, or both in
 * one; or a light bulb. Everything differs in shape, not only in colour.
 */
public record LineIcon(Optional<Dot> dot, Optional<Execution.State> arrow, boolean bulb)
    implements Icon {
  private static final int SIDE = 16;
  private static final Map<Dot, SvgIcon> DOTS = dots("");
  private static final Map<Dot, SvgIcon> SMALL_DOTS = dots("-small");

  /** An outline while the program runs, filled where it is held. */
  private static final Map<Execution.State, SvgIcon> ARROWS =
      Map.of(
          Execution.State.RUNNING, drawing("arrow-running"),
          Execution.State.HELD, drawing("arrow-held"),
          Execution.State.FAILED, drawing("arrow-failed"));

  /** Outlines, with room for a dot. */
  private static final Map<Execution.State, SvgIcon> ARROWS_AROUND =
      Map.of(
          Execution.State.RUNNING, drawing("arrow-running"),
          Execution.State.HELD, drawing("arrow-running"),
          Execution.State.FAILED, drawing("arrow-failed-around"));

  private static final SvgIcon BULB = drawing("bulb");

  /**
   * A breakpoint.
   *
   * @param filled whether it is enabled; a ring otherwise
   */
  public record Dot(boolean filled, Kind kind, Reach reach) {
    private String drawing(String size) {
      return (kind == Kind.LOG ? "log" : "dot")
          + size
          + (filled || reach == Reach.NOWHERE ? "" : "-off")
          + (kind == Kind.CONDITIONAL ? "-conditional" : "")
          + switch (reach) {
            case HERE -> "";
            case BELOW -> "-below";
            case NOWHERE -> "-nowhere";
          };
    }
  }

  /** What a breakpoint does. */
  public enum Kind {
    /** Stops the program each time: a disc. */
    STOP,
    /** Stops it only sometimes: a disc with two bars in it. */
    CONDITIONAL,
    /** Writes a message and stops nothing: a diamond. */
    LOG
  }

  /** Where a breakpoint stops the program. */
  public enum Reach {
    /** On the line itself. */
    HERE,
    /** On a line below: an arrow leads there. */
    BELOW,
    /** Nowhere: it is crossed out. */
    NOWHERE
  }

  private static SvgIcon drawing(String name) {
    return SvgIcon.of("line/" + name, SIDE).lit();
  }

  private static Map<Dot, SvgIcon> dots(String size) {
    Map<Dot, SvgIcon> dots = new HashMap<>();
    for (Reach reach : Reach.values()) {
      for (boolean filled : new boolean[] {false, true}) {
        for (Kind kind : Kind.values()) {
          Dot dot = new Dot(filled, kind, reach);
          dots.put(dot, drawing(dot.drawing(size)));
        }
      }
    }
    return Map.copyOf(dots);
  }

  @Override
  public int getIconWidth() {
    return BULB.getIconWidth();
  }

  @Override
  public int getIconHeight() {
    return BULB.getIconHeight();
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    layers().forEach(each -> each.paintIcon(c, g, x, y));
  }

  /** What it is painted from, the lowest first. */
  List<SvgIcon> layers() {
    List<SvgIcon> layers = new ArrayList<>();
    arrow.map((dot.isPresent() ? ARROWS_AROUND : ARROWS)::get).ifPresent(layers::add);
    dot.map((arrow.isPresent() ? SMALL_DOTS : DOTS)::get).ifPresent(layers::add);
    if (bulb) {
      layers.add(BULB);
    }
    return layers;
  }
}
