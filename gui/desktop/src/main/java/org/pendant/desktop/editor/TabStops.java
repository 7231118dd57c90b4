package org.pendant.desktop.editor;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.OptionalInt;
import javax.swing.text.BadLocationException;
import javax.swing.text.Position;
import org.pendant.desktop.editor.text.TextSpan;

/**
 * Tab stops: the arguments of calls that were completed. TAB selects the next one and, behind the
 * last, leaves the brackets; SHIFT TAB selects the one before. A call is forgotten when the caret
 * is outside of its brackets.
 */
final class TabStops {
  /** The bracket or comma before each argument, and the bracket behind the last. */
  private record Call(List<Position> marks) {
    int from(int argument) {
      int mark = marks.get(argument).getOffset() + 1;
      return argument == 0 ? mark : mark + 1;
    }

    int to(int argument) {
      return marks.get(argument + 1).getOffset();
    }

    int arguments() {
      return marks.size() - 1;
    }

    /** The argument in which {@code offset} is. */
    OptionalInt at(int offset) {
      for (int i = 0; i < arguments(); i++) {
        if (from(i) <= offset && offset <= to(i)) {
          return OptionalInt.of(i);
        }
      }
      return OptionalInt.empty();
    }
  }

  private final ScriptArea area;
  private final Deque<Call> calls = new ArrayDeque<>();

  /** Takes over TAB in {@code area} while there are arguments to fill in. */
  TabStops(ScriptArea area) {
    this.area = area;
    area.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            pressed(event);
          }
        });
  }

  /**
   * A call has been written: its first argument is selected.
   *
   * @param arguments one or more, each behind a bracket or a comma and a blank
   */
  void begin(List<TextSpan> arguments) {
    List<Position> marks = new ArrayList<>();
    for (TextSpan each : arguments) {
      marks.add(mark(each.start() - (marks.isEmpty() ? 1 : 2)));
    }
    marks.add(mark(arguments.getLast().end()));
    calls.push(new Call(marks));
    select(calls.element(), 0);
  }

  private Position mark(int offset) {
    try {
      return area.getDocument().createPosition(offset);
    } catch (BadLocationException e) {
      throw new IllegalStateException("the call has just been written", e);
    }
  }

  private void pressed(KeyEvent event) {
    if (event.isConsumed() || event.isControlDown() || event.isAltDown()) {
      return;
    }
    if (event.getKeyCode() == KeyEvent.VK_ESCAPE) {
      calls.clear();
    } else if (event.getKeyCode() == KeyEvent.VK_TAB && move(event.isShiftDown() ? -1 : 1)) {
      event.consume();
    }
  }

  /** Selects another argument; false if the caret is in none. */
  private boolean move(int by) {
    while (!calls.isEmpty()) {
      Call call = calls.element();
      OptionalInt at = call.at(area.getCaretPosition());
      int next = at.orElse(0) + by;
      if (at.isEmpty() || next < 0) {
        calls.pop();
      } else if (next == call.arguments()) {
        area.setCaretPosition(call.to(next - 1) + 1);
        calls.pop();
        return true;
      } else {
        select(call, next);
        return true;
      }
    }
    return false;
  }

  private void select(Call call, int argument) {
    area.setCaretPosition(call.from(argument));
    area.moveCaretPosition(call.to(argument));
  }

  /** Whether an argument is selected as a whole: what is typed takes its place. */
  boolean selected() {
    if (calls.isEmpty()) {
      return false;
    }
    Call call = calls.element();
    OptionalInt at = call.at(area.getCaretPosition());
    return at.isPresent()
        && area.getSelectionStart() == call.from(at.getAsInt())
        && area.getSelectionEnd() == call.to(at.getAsInt())
        && area.getSelectionStart() < area.getSelectionEnd();
  }
}
