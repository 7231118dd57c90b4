package org.pendant.gui.editor;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.IntConsumer;
import javax.swing.SwingUtilities;
import javax.swing.text.BadLocationException;
import org.fife.ui.rtextarea.Gutter;
import org.fife.ui.rtextarea.GutterIconInfo;
import org.fife.ui.rtextarea.IconRowHeader;

/** The marks beside the lines of one script: they move with their lines. Lines count from 1. */
final class GutterMarks {
  private final ScriptArea area;
  private final Gutter gutter;
  private final List<GutterIconInfo> breakpoints = new ArrayList<>();
  private Optional<GutterIconInfo> execution = Optional.empty();
  private Optional<Object> executionBand = Optional.empty();
  private Optional<GutterIconInfo> bulb = Optional.empty();
  private int executionLine;

  /**
   * The marks beside {@code area}.
   *
   * @param clicked told of the line where somebody clicks into the margin
   * @param bulbClicked told when somebody clicks on the light bulb
   */
  GutterMarks(ScriptArea area, Gutter gutter, IntConsumer clicked, Runnable bulbClicked) {
    this.area = area;
    this.gutter = gutter;
    gutter.setIconRowHeaderEnabled(true);
    gutter.setBookmarkingEnabled(false);
    for (Component part : gutter.getComponents()) {
      if (part instanceof IconRowHeader margin) {
        margin.setName("breakpoint-margin");
        margin.getAccessibleContext().setAccessibleName("Breakpoints");
        margin.setToolTipText("Click to set or clear a breakpoint (F9)");
        margin.addMouseListener(new Clicks(clicked, bulbClicked));
      }
    }
  }

  /** Lines with a breakpoint. */
  SortedSet<Integer> breakpoints() {
    SortedSet<Integer> lines = new TreeSet<>();
    breakpoints.forEach(mark -> lines.add(area.lineAt(mark.getMarkedOffset())));
    return Collections.unmodifiableSortedSet(lines);
  }

  void addBreakpoint(int line) {
    if (!breakpoints().contains(line)) {
      breakpoints.add(mark(line, GutterIcon.BREAKPOINT, "Breakpoint: the program stops before"));
    }
  }

  void removeBreakpoint(int line) {
    breakpoints.removeIf(
        mark -> {
          boolean gone = area.lineAt(mark.getMarkedOffset()) == line;
          if (gone) {
            gutter.removeTrackingIcon(mark);
          }
          return gone;
        });
  }

  /** Marks the line that runs; 0 for none. */
  void setExecutionLine(int line) {
    if (line == executionLine) {
      return;
    }
    executionLine = line;
    paintExecution(line);
  }

  /** Paints what is coloured again, in the present theme. */
  void themeChanged() {
    paintExecution(
        execution.map(mark -> area.lineAt(mark.getMarkedOffset())).orElse(executionLine));
  }

  private void paintExecution(int line) {
    execution.ifPresent(gutter::removeTrackingIcon);
    executionBand.ifPresent(area::removeLineHighlight);
    execution = Optional.empty();
    executionBand = Optional.empty();
    // the band of the line that runs must not lie under that of the caret
    area.setHighlightCurrentLine(line < 1);
    if (line < 1 || line > area.getLineCount()) {
      return;
    }
    execution = Optional.of(mark(line, GutterIcon.EXECUTION, "This line runs"));
    try {
      executionBand =
          Optional.of(area.addLineHighlight(line - 1, EditorColors.now().executionLine()));
    } catch (BadLocationException e) {
      throw new IllegalStateException("line " + line + " is in the text", e);
    }
  }

  /** Shows the light bulb beside a line; 0 for nowhere. */
  void setBulb(int line) {
    bulb.ifPresent(gutter::removeTrackingIcon);
    bulb = Optional.empty();
    if (line > 0) {
      bulb = Optional.of(mark(line, GutterIcon.BULB, "There is a quick fix (alt ENTER)"));
    }
  }

  private GutterIconInfo mark(int line, GutterIcon icon, String tip) {
    try {
      return gutter.addOffsetTrackingIcon(area.line(line).start(), icon, tip);
    } catch (BadLocationException e) {
      throw new IllegalArgumentException("line " + line + " is not in the text", e);
    }
  }

  /** Clicks beside lines. */
  private final class Clicks extends MouseAdapter {
    private final IntConsumer clicked;
    private final Runnable bulbClicked;

    Clicks(IntConsumer clicked, Runnable bulbClicked) {
      this.clicked = clicked;
      this.bulbClicked = bulbClicked;
    }

    @Override
    public void mousePressed(MouseEvent event) {
      if (!SwingUtilities.isLeftMouseButton(event)) {
        return;
      }
      Point there = SwingUtilities.convertPoint(event.getComponent(), event.getPoint(), area);
      int line = area.lineAt(area.viewToModel2D(there));
      boolean onBulb = bulb.filter(mark -> area.lineAt(mark.getMarkedOffset()) == line).isPresent();
      if (onBulb) {
        bulbClicked.run();
      } else {
        clicked.accept(line);
      }
    }
  }
}
