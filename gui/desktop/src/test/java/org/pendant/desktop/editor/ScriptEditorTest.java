package org.pendant.desktop.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.awt.event.MouseEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JToolTip;
import javax.swing.UIManager;
import javax.swing.text.DefaultEditorKit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.layout.FloatingPanel;
import org.pendant.kit.theme.PreviewLook;

@Tag("slow")
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

  private static boolean tipShown() {
    return Stream.of(Window.getWindows()).anyMatch(ScriptEditorTest::showsTip);
  }

  private static boolean showsTip(Component in) {
    return (in instanceof JToolTip && in.isShowing())
        || (in instanceof Container inner
            && Stream.of(inner.getComponents()).anyMatch(ScriptEditorTest::showsTip));
  }

  @Test
  void theTooltipGoesWhenTheTextScrolls() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.setToolTipText("told");
          // also where no window has the focus
          UIManager.put("ToolTipManager.enableToolTipMode", "allWindows");
          area.setText("a = 1\n".repeat(200));
          area.setCaretPosition(0);
          area.getRootPane().validate();
          area.scrollRectToVisible(new Rectangle(0, 0, 1, 1));
        });
    EventQueue.invokeAndWait(
        () -> {
          KeyEvent keys =
              new KeyEvent(
                  area,
                  KeyEvent.KEY_PRESSED,
                  0,
                  InputEvent.CTRL_DOWN_MASK,
                  KeyEvent.VK_F1,
                  KeyEvent.CHAR_UNDEFINED);
          Stream.of(area.getKeyListeners()).forEach(each -> each.keyPressed(keys));
          assertTrue(tipShown(), "there is a tooltip");
          area.scrollRectToVisible(new Rectangle(0, area.getHeight() - 1, 1, 1));
        });
    EventQueue.invokeAndWait(
        () -> {
          UIManager.put("ToolTipManager.enableToolTipMode", null);
          assertFalse(tipShown(), "it has gone");
        });
  }

  /** As a script is that is generated after its editor was made. */
  @Test
  void aTextThatComesIntoAnEmptyEditorIsShownFromItsBeginning()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.setText("");
          program.setText(TEXT);
          assertEquals(TEXT, area.getText());
          assertEquals(0, area.getCaretPosition());
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

  @Test
  void tabGoesFromOneArgumentOfACompletedCallToTheNextAndOut()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.setText("f(n, b)");
          area.tabStops().begin(List.of(new TextSpan(2, 3), new TextSpan(5, 6)));
          assertEquals("n", area.getSelectedText());
          type('[');
          type('1');
          assertEquals("f([1], b)", area.getText());
          press(KeyEvent.VK_TAB, 0);
          assertEquals("b", area.getSelectedText());
          press(KeyEvent.VK_TAB, InputEvent.SHIFT_DOWN_MASK);
          assertEquals("[1]", area.getSelectedText());
          press(KeyEvent.VK_TAB, 0);
          "True".chars().forEach(this::type);
          press(KeyEvent.VK_TAB, 0);
          assertEquals("f([1], True)", area.getText());
          assertEquals(area.getText().length(), area.getCaretPosition());
          assertFalse(press(KeyEvent.VK_TAB, 0), "behind the call TAB is the text's again");
        });
  }

  @Test
  void aCallInAnArgumentIsFilledInBeforeTheNextArgument()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.setText("f(n, b)");
          area.tabStops().begin(List.of(new TextSpan(2, 3), new TextSpan(5, 6)));
          area.replaceRange("g(x)", 2, 3);
          area.tabStops().begin(List.of(new TextSpan(4, 5)));
          assertEquals("x", area.getSelectedText());
          press(KeyEvent.VK_TAB, 0);
          press(KeyEvent.VK_TAB, 0);
          assertEquals("b", area.getSelectedText());
          area.setCaretPosition(0);
          assertFalse(press(KeyEvent.VK_TAB, 0), "outside of the call TAB is the text's");
        });
  }

  @Test
  void whatFloatsOverTheTextHasTheColoursOfAThemeThatWasChosenMeanwhile()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          JLabel label = new JLabel("takes");
          FloatingPanel panel = new FloatingPanel(area, label);
          Color before = label.getForeground();
          PreviewLook.install(true);
          panel.show(area.place(0), false);
          assertEquals(new JLabel().getForeground(), label.getForeground());
          assertNotEquals(before, label.getForeground());
          PreviewLook.install(false);
        });
  }

  /** Whether the key did not get to the text itself. */
  private boolean press(int key, int modifiers) {
    KeyEvent event =
        new KeyEvent(area, KeyEvent.KEY_PRESSED, 0, modifiers, key, KeyEvent.CHAR_UNDEFINED);
    for (KeyListener each : area.getKeyListeners()) {
      each.keyPressed(event);
    }
    return event.isConsumed();
  }

  @Test
  void aBlockGetsItsEnd() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.setText("def f():\nend\n");
          area.setCaretPosition(area.line(1).end());
          enter();
          "if a:".chars().forEach(this::type);
          enter();
          "sync()".chars().forEach(this::type);
          assertEquals("def f():\n  if a:\n    sync()\n  end\nend\n", area.getText());
          enter();
          "end".chars().forEach(this::type);
          enter();
          assertEquals(
              "def f():\n  if a:\n    sync()\n  end\n  \nend\n", area.getText(), "not two ends");
        });
  }

  private void enter() {
    area.getActionMap()
        .get(DefaultEditorKit.insertBreakAction)
        .actionPerformed(new ActionEvent(area, ActionEvent.ACTION_PERFORMED, "\n"));
  }

  @Test
  void bracketsComeInPairsAndGoInPairs() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.setText("");
          "f(g[0]".chars().forEach(this::type);
          assertEquals("f(g[0])", area.getText());
          type(')');
          assertEquals("f(g[0])", area.getText());
          type('(');
          area.getActionMap()
              .get(DefaultEditorKit.deletePrevCharAction)
              .actionPerformed(new ActionEvent(area, ActionEvent.ACTION_PERFORMED, "\b"));
          assertEquals("f(g[0])", area.getText());
          area.select(2, 6);
          type('(');
          assertEquals("f((g[0]))", area.getText());
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

  @Test
  void aClosedProgramIsOpenedAgainWithTheTextThatItHad()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          window
              .editor()
              .setBreakpointMemory(of -> new TreeSet<>(of == program ? Set.of(4) : Set.of()));
          window.editor().close();
          assertNotEquals(program, window.editor().current().program());
          window.run("editor.reopen");
          assertEquals(program, window.editor().current().program());
          assertEquals(new TreeSet<>(Set.of(4)), window.editor().breakpoints(program));
        });
  }

  @Test
  void jumpsAreGoneBackAndForward() throws InterruptedException, InvocationTargetException {
    analysed();
    EventQueue.invokeAndWait(
        () -> {
          int use = area.getText().indexOf("a)");
          area.setCaretPosition(use);
          window.run("editor.definition");
          assertEquals(2, window.editor().caretLine());
          window.run("editor.back");
          assertEquals(use, area.getCaretPosition());
          window.run("editor.forward");
          assertEquals(2, window.editor().caretLine());
        });
  }

  @Test
  void aTextThatIsReadAgainKeepsItsBreakpoints()
      throws InterruptedException, InvocationTargetException {
    analysed();
    EventQueue.invokeAndWait(
        () -> {
          window.editor().toggleBreakpoint(program, 4);
          program.setText("# from the disk\n" + TEXT);
          assertEquals(new TreeSet<>(Set.of(5)), window.editor().breakpoints(program));
        });
  }

  @Test
  void linesAreMovedDuplicatedAndDeleted() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.setCaretPosition(area.line(2).start() + 3);
          window.run("editor.duplicate");
          assertEquals(TEXT.replace("  a = 1\n", "  a = 1\n  a = 1\n"), area.getText());
          assertEquals(3, window.editor().caretLine());
          window.run("editor.delete-line");
          assertEquals(TEXT, area.getText());
          area.undoLastAction();
          area.undoLastAction();
          assertEquals(TEXT, area.getText());
        });
  }

  @Test
  void aBreakpointIsThereAtOnceAndMovesWhenTheTextIsRead()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          area.replaceRange("# ", 0, 0);
          area.replaceRange("", 0, 2);
          window.editor().toggleBreakpoint(program, 3);
          assertEquals(new TreeSet<>(Set.of(3)), window.editor().breakpoints(program));
        });
    analysed();
    EventQueue.invokeAndWait(
        () -> assertEquals(new TreeSet<>(Set.of(4)), window.editor().breakpoints(program)));
  }

  private boolean inSight(int line) {
    return area.getVisibleRect().contains(area.place(area.line(line).start()).getLocation());
  }

  @Test
  void theLineThatRunsIsKeptInSightUntilPeopleScroll()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          program.setText("a = 1\n".repeat(300));
          area.setCaretPosition(0);
        });
    EventQueue.invokeAndWait(() -> window.editor().setExecution(program, Execution.running(200)));
    EventQueue.invokeAndWait(() -> assertTrue(inSight(200)));
    EventQueue.invokeAndWait(() -> window.frame().setSize(1200, 500));
    EventQueue.invokeAndWait(() -> window.frame().validate());
    EventQueue.invokeAndWait(
        () -> {
          assertTrue(window.editor().follows(), "a smaller window is no scrolling");
          assertTrue(inSight(200));
        });
    EventQueue.invokeAndWait(() -> area.scrollRectToVisible(new Rectangle(0, 0, 1, 1)));
    EventQueue.invokeAndWait(
        () -> {
          assertFalse(window.editor().follows());
          window.editor().setExecution(program, Execution.running(250));
          assertFalse(inSight(250));
          window.editor().followAgain();
          window.editor().setExecution(program, Execution.running(100));
          assertTrue(inSight(100));
        });
  }

  @Test
  void aVariableUnderThePointerTellsItsValue()
      throws InterruptedException, InvocationTargetException {
    analysed();
    EventQueue.invokeAndWait(
        () -> {
          window.editor().setValues((of, name) -> Optional.of(name + "?"));
          Rectangle place = area.place(area.getText().indexOf("a = 1"));
          String tip =
              area.getToolTipText(
                  new MouseEvent(
                      area, MouseEvent.MOUSE_MOVED, 0, 0, place.x + 1, place.y + 2, 0, false));
          assertTrue(tip.contains("a = a?"), tip);
        });
  }
}
