package org.pendant.gui.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.gui.session.ProgramDocument;

final class ScriptEditorTest {
  private static final String TEXT = "def main():\n  a = 1\n\n  textmsg(a)\nend\n";

  private final ProgramDocument program = ProgramDocument.untitled("test.script", TEXT);
  private EditorWindow window;
  private ScriptArea area;

  @BeforeEach
  void openWindow() throws InterruptedException, InvocationTargetException {
    assumeFalse(GraphicsEnvironment.isHeadless(), "a window needs a display");
    EventQueue.invokeAndWait(
        () -> {
          window = EditorWindow.open(false, List.of(program));
          area = window.editor().current().area();
        });
  }

  @AfterEach
  void closeWindow() throws InterruptedException, InvocationTargetException {
    if (window != null) {
      EventQueue.invokeAndWait(window::close);
    }
  }

  /** Waits until the text as it is has been analysed. */
  private void analysed() throws InterruptedException, InvocationTargetException {
    CountDownLatch done = new CountDownLatch(1);
    EventQueue.invokeAndWait(
        () -> {
          Runnable look =
              () -> {
                if (window.editor().current().analysed().isPresent()) {
                  done.countDown();
                }
              };
          window.editor().addListener(look::run);
          look.run();
        });
    done.await();
  }

  @Test
  void documentAndTextStayTheSame() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.setCaretPosition(area.line(2).end());
          area.replaceSelection("0");
          assertEquals(TEXT.replace("a = 1", "a = 10"), program.text());
          program.replace(0, 0, "# first\n");
          assertEquals(program.text(), area.getText());
          area.undoLastAction();
          area.undoLastAction();
          assertEquals(TEXT, program.text());
        });
  }

  @Test
  void typingEndGoesBackToTheHead() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.setCaretPosition(area.line(3).start());
          "  if a == 1:\n    sync()\n    end".chars().forEach(this::type);
          assertEquals("  end", area.text(area.line(5)));
        });
  }

  private void type(int c) {
    area.replaceSelection(Character.toString(c));
  }

  @Test
  void breakpointsStandWhereTheProgramCanStop()
      throws InterruptedException, InvocationTargetException {
    analysed();
    List<String> told = new ArrayList<>();
    EventQueue.invokeAndWait(
        () -> {
          window
              .editor()
              .addBreakpointListener(
                  new BreakpointListener() {
                    @Override
                    public void breakpointsMoved(
                        ProgramDocument of, SortedMap<Integer, Integer> moves) {
                      told.add("moved " + moves);
                    }

                    @Override
                    public void breakpointsChanged(ProgramDocument of, SortedSet<Integer> lines) {
                      told.add("at " + lines);
                    }
                  });
          window.editor().toggleBreakpoint(program, 3);
          area.replaceRange("\n", 0, 0);
          assertEquals(List.of("at [4]", "moved {4=5}", "at [5]"), told);
          assertEquals(new TreeSet<>(List.of(5)), window.editor().breakpoints(program));
        });
  }

  @Test
  void breakpointsGoWithLinesThatAreMoved() throws InterruptedException, InvocationTargetException {
    analysed();
    EventQueue.invokeAndWait(
        () -> {
          window.editor().toggleBreakpoint(program, 4);
          area.setCaretPosition(area.line(4).start());
          window.run("editor.move-up");
          assertEquals(new TreeSet<>(List.of(3)), window.editor().breakpoints(program));
          area.undoLastAction();
          window.run("editor.move-down");
          assertEquals(1, window.editor().breakpoints(program).size());
        });
  }

  @Test
  void blocksCanBeFolded() throws InterruptedException, InvocationTargetException {
    analysed();
    EventQueue.invokeAndWait(
        () -> {
          assertEquals(1, area.getFoldManager().getFoldCount());
          area.setCaretPosition(area.line(2).start());
          window.run("editor.fold");
          assertEquals(3, area.getFoldManager().getHiddenLineCount() - 1);
        });
  }

  @Test
  void aProgramWithChangesIsClosedOnlyAfterAnAnswer()
      throws InterruptedException, InvocationTargetException {
    List<Boolean> asked = new ArrayList<>();
    EventQueue.invokeAndWait(
        () -> {
          area.replaceSelection("x");
          window.editor().close();
          asked.add(window.editor().current().notice().isVisible());
          assertEquals(program, window.editor().current().program());
        });
    assertEquals(List.of(true), asked);
  }
}
