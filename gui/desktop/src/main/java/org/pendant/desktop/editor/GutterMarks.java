package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.IntConsumer;
import java.util.function.IntFunction;
import java.util.function.IntUnaryOperator;
import javax.swing.JPopupMenu;
import javax.swing.SwingUtilities;
import javax.swing.text.BadLocationException;
import javax.swing.text.Position;
import org.fife.ui.rtextarea.Gutter;
import org.fife.ui.rtextarea.GutterIconInfo;
import org.fife.ui.rtextarea.IconRowHeader;

/**
 * Gutter marks: the marks beside the lines of one script: they move with their lines. Lines count
 * from 1.
 */
final class GutterMarks {
  private final ScriptArea area;
  private final Gutter gutter;
  private final List<Mark> breakpoints = new ArrayList<>();
  private final List<Shown> shown = new ArrayList<>();
  private Optional<SortedSet<Integer>> statementLines = Optional.empty();
  private Optional<Position> execution = Optional.empty();
  private Execution state = Execution.NONE;
  private int bulb;

  /** A breakpoint: where it is, where it was when the user was told last, and how it looks. */
  private static final class Mark {
    private final Position at;
    private int toldLine;
    private BreakpointMark look = BreakpointMark.PLAIN;

    Mark(Position at, int line) {
      this.at = at;
      toldLine = line;
    }
  }

  /** What stands beside a line. */
  private record Beside(LineIcon icon, String tip) {}

  /** What the margin has. */
  private record Shown(GutterIconInfo info, Beside what) {}

  /**
   * The marks beside {@code area}.
   *
   * @param clicked told of the line where the user clicks into the margin
   * @param bulbClicked told when the user clicks on the light bulb
   * @param menu what the other button of the mouse opens beside a line
   */
  GutterMarks(
      ScriptArea area,
      Gutter gutter,
      IntConsumer clicked,
      Runnable bulbClicked,
      IntFunction<JPopupMenu> menu) {
    this.area = area;
    this.gutter = gutter;
    gutter.setIconRowHeaderEnabled(true);
    gutter.setBookmarkingEnabled(false);
    for (Component part : gutter.getComponents()) {
      if (part instanceof IconRowHeader margin) {
        margin.setName("breakpoint-margin");
        margin.getAccessibleContext().setAccessibleName(text("breakpoints"));
        margin.setToolTipText(text("clickToSetOrClearA"));
        margin.addMouseListener(new Clicks(clicked, bulbClicked, menu));
      }
    }
  }

  // --- breakpoints

  /** Lines with a breakpoint. */
  SortedSet<Integer> breakpoints() {
    SortedSet<Integer> lines = new TreeSet<>();
    breakpoints.forEach(mark -> lines.add(line(mark)));
    return Collections.unmodifiableSortedSet(lines);
  }

  void addBreakpoint(int line) {
    if (!breakpoints().contains(line)) {
      breakpoints.add(new Mark(position(line), line));
      refresh();
    }
  }

  void removeBreakpoint(int line) {
    breakpoints.removeIf(mark -> line(mark) == line);
    refresh();
  }

  /** Shows what others know of breakpoints, by their lines. */
  void setLooks(Map<Integer, BreakpointMark> looks) {
    for (Mark mark : breakpoints) {
      mark.look = looks.getOrDefault(line(mark), BreakpointMark.PLAIN);
    }
    refresh();
  }

  /** Says on which lines the program can stop; empty while that is not known. */
  void setStatementLines(Optional<SortedSet<Integer>> lines) {
    statementLines = lines;
    refresh();
  }

  /**
   * Where breakpoints have moved since the last call, each line by the one before; empty if none
   * has.
   */
  SortedMap<Integer, Integer> takeMoves() {
    SortedMap<Integer, Integer> moves = new TreeMap<>();
    boolean moved = false;
    for (Mark mark : breakpoints) {
      int now = line(mark);
      moves.putIfAbsent(mark.toldLine, now);
      moved |= now != mark.toldLine;
      mark.toldLine = now;
    }
    return moved ? moves : Collections.emptySortedMap();
  }

  /**
   * Does an edit that takes lines to other places.
   *
   * @param newLine where each line is afterwards
   */
  void whileMoving(Runnable edit, IntUnaryOperator newLine) {
    List<Integer> before = breakpoints.stream().map(this::line).toList();
    edit.run();
    for (int i = 0; i < before.size(); i++) {
      Mark old = breakpoints.get(i);
      Mark there = new Mark(position(newLine.applyAsInt(before.get(i))), old.toldLine);
      there.look = old.look;
      breakpoints.set(i, there);
    }
    refresh();
  }

  private int line(Mark mark) {
    return area.lineAt(mark.at.getOffset());
  }

  private Position position(int line) {
    try {
      return area.getDocument().createPosition(area.line(line).start());
    } catch (BadLocationException e) {
      throw new IllegalArgumentException("line " + line + " is not in the text", e);
    }
  }

  // --- the other marks

  /** Marks where the program is. */
  void setExecution(Execution wanted) {
    if (wanted.equals(state)) {
      return;
    }
    state = wanted;
    boolean inText = wanted.line() >= 1 && wanted.line() <= area.getLineCount();
    execution = inText ? Optional.of(position(wanted.line())) : Optional.empty();
    area.setExecution(inText ? wanted : Execution.NONE);
    refresh();
  }

  /** Shows the light bulb beside a line; 0 for nowhere. */
  void setBulb(int line) {
    if (bulb != line) {
      bulb = line;
      refresh();
    }
  }

  /** The text or the theme is another: whatever stands in the wrong place moves. */
  void refresh() {
    SortedMap<Integer, Beside> wanted = wanted();
    SortedMap<Integer, Beside> present = new TreeMap<>();
    shown.forEach(each -> present.put(area.lineAt(each.info().getMarkedOffset()), each.what()));
    if (wanted.equals(present) && present.size() == shown.size()) {
      return;
    }
    shown.forEach(each -> gutter.removeTrackingIcon(each.info()));
    shown.clear();
    wanted.forEach(
        (line, what) -> {
          try {
            shown.add(
                new Shown(
                    gutter.addOffsetTrackingIcon(area.line(line).start(), what.icon(), what.tip()),
                    what));
          } catch (BadLocationException e) {
            throw new IllegalArgumentException("line " + line + " is not in the text", e);
          }
        });
  }

  private SortedMap<Integer, Beside> wanted() {
    SortedMap<Integer, Beside> wanted = new TreeMap<>();
    int here = execution.map(at -> area.lineAt(at.getOffset())).orElse(0);
    for (Mark mark : breakpoints) {
      int line = line(mark);
      wanted.put(line, breakpoint(line, mark.look, line == here));
    }
    if (here > 0) {
      wanted.putIfAbsent(
          here,
          new Beside(
              new LineIcon(Optional.empty(), Optional.of(state.state()), false), stateTip()));
    }
    if (bulb > 0 && bulb <= area.getLineCount()) {
      wanted.putIfAbsent(
          bulb,
          new Beside(
              new LineIcon(Optional.empty(), Optional.empty(), true), text("thereIsAQuickFixAlt")));
    }
    return wanted;
  }

  private Beside breakpoint(int line, BreakpointMark look, boolean here) {
    LineIcon.Reach reach = LineIcon.Reach.HERE;
    String tip = look.about();
    if (statementLines.isPresent() && !statementLines.get().contains(line)) {
      SortedSet<Integer> below = statementLines.get().tailSet(line);
      reach = below.isEmpty() ? LineIcon.Reach.NOWHERE : LineIcon.Reach.BELOW;
      tip =
          below.isEmpty()
              ? text("thisBreakpointHasNoEffectNo")
              : text("noStatementBeginsHereSoIt", tip, below.first());
    }
    LineIcon.Dot dot = new LineIcon.Dot(look.enabled(), look.kind(), reach);
    Optional<Execution.State> arrow = here ? Optional.of(state.state()) : Optional.empty();
    return new Beside(
        new LineIcon(Optional.of(dot), arrow, false),
        here ? text("stateAndBreakpoint", stateTip(), tip) : tip);
  }

  private String stateTip() {
    if (!state.note().isEmpty()) {
      return state.note();
    }
    return switch (state.state()) {
      case RUNNING -> text("thisLineRuns");
      case HELD -> text("theProgramIsPausedBeforeThis");
      case FAILED -> text("theProgramFailedHere");
    };
  }

  /** Clicks beside lines. */
  private final class Clicks extends MouseAdapter {
    private final IntConsumer clicked;
    private final Runnable bulbClicked;
    private final IntFunction<JPopupMenu> menu;

    Clicks(IntConsumer clicked, Runnable bulbClicked, IntFunction<JPopupMenu> menu) {
      this.clicked = clicked;
      this.bulbClicked = bulbClicked;
      this.menu = menu;
    }

    private int line(MouseEvent event) {
      Point there = SwingUtilities.convertPoint(event.getComponent(), event.getPoint(), area);
      return area.lineAt(area.viewToModel2D(there));
    }

    private void open(MouseEvent event) {
      if (event.isPopupTrigger()) {
        menu.apply(line(event)).show(event.getComponent(), event.getX(), event.getY());
      }
    }

    @Override
    public void mouseReleased(MouseEvent event) {
      open(event);
    }

    @Override
    public void mousePressed(MouseEvent event) {
      open(event);
      if (event.isPopupTrigger() || !SwingUtilities.isLeftMouseButton(event)) {
        return;
      }
      int line = line(event);
      boolean onBulb =
          shown.stream()
              .anyMatch(
                  each ->
                      each.what().icon().bulb()
                          && area.lineAt(each.info().getMarkedOffset()) == line);
      if (onBulb) {
        bulbClicked.run();
      } else {
        clicked.accept(line);
      }
    }
  }
}
