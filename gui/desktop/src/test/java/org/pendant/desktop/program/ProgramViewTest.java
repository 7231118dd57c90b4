package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.debug.DebugPresenter;
import org.pendant.desktop.debug.EditorLink;
import org.pendant.desktop.editor.ScriptEditor;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.theme.Contrast;
import org.pendant.kit.theme.Look;
import org.pendant.kit.theme.Theme;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.text.ProgramText;

@Tag("slow")
final class ProgramViewTest {
  private final ProgramDocument document =
      ProgramDocument.untitled("cell.pendant", ProgramText.write(ProgramTree.empty()));
  private PreviewWorkbench workbench;
  private Look look;
  private Programs programs;
  private TreePrograms trees;
  private ScriptEditor editor;
  private JFrame frame;
  private ProgramView view;

  @BeforeEach
  void openWindow() throws InterruptedException, InvocationTargetException {
    assumeFalse(GraphicsEnvironment.isHeadless(), "a window needs a display");
    EventQueue.invokeAndWait(this::build);
  }

  private void build() {
    workbench = new PreviewWorkbench(RobotSession.start(ControllerOptions.headless()));
    look = new Look(workbench.settings());
    look.install();
    look.setTheme(Theme.LIGHT);
    programs = new Programs(document);
    editor = new ScriptEditor(workbench, programs);
    DebugPresenter debug = new DebugPresenter(workbench, programs);
    var _ = new EditorLink(editor, debug, programs);
    trees =
        new TreePrograms(
            programs, new ActiveInstallation(), Runnable::run, EventQueue::invokeLater);
    ScriptLink link = new ScriptLink(editor, debug, workbench::notify);
    trees.setSink(link);
    view =
        new ProgramView(
            workbench, programs, trees, link, (what, accepted, left) -> accepted.run(), s -> {});
    frame = new JFrame("Program");
    frame.add(view.component(), BorderLayout.CENTER);
    frame.setSize(1100, 700);
    frame.setVisible(true);
  }

  @AfterEach
  void closeWindow() throws InterruptedException, InvocationTargetException {
    if (frame != null) {
      EventQueue.invokeAndWait(
          () -> {
            frame.dispose();
            workbench.session().close();
          });
    }
  }

  @Test
  void tabsBesideTheTreeStayInOneRowInANarrowWindow()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          JTabbedPane tabs = find(frame, "program-tabs", JTabbedPane.class);
          JLabel palette = new JLabel("nodes");
          tabs.insertTab("Add", null, palette, null, 0);
          tabs.setSize(258, 400);
          tabs.doLayout();
          for (int i = 0; i < tabs.getTabCount(); i++) {
            Rectangle tab = tabs.getBoundsAt(i);
            assertEquals(tabs.getBoundsAt(0).y, tab.y, tabs.getTitleAt(i));
            assertTrue(tab.x + tab.width <= 258, tabs.getTitleAt(i) + " ends at " + tab.getMaxX());
          }
          tabs.remove(palette);
        });
  }

  private static <T extends Component> T find(Container in, String name, Class<T> type) {
    return search(in, name)
        .map(type::cast)
        .orElseThrow(() -> new AssertionError("there is no " + name));
  }

  private static Optional<Component> search(Container in, String name) {
    for (Component each : in.getComponents()) {
      Optional<Component> found =
          name.equals(each.getName())
              ? Optional.of(each)
              : each instanceof Container below ? search(below, name) : Optional.empty();
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  private TreeProgram program() {
    return trees.of(document).orElseThrow();
  }

  private String tree() {
    return Trees.shown(program().tree());
  }

  /** Clicks on an entry of the palette, as a mouse would. */
  private void click(String kind) {
    JList<?> palette = find(frame, "program-palette", JList.class);
    for (int i = 0; i < palette.getModel().getSize(); i++) {
      if (palette.getModel().getElementAt(i).toString().equals(kind)) {
        Rectangle cell = palette.getCellBounds(i, i);
        for (int id : new int[] {MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED}) {
          palette.dispatchEvent(
              new MouseEvent(
                  palette,
                  id,
                  0,
                  InputEvent.BUTTON1_DOWN_MASK,
                  cell.x + 20,
                  cell.y + 5,
                  1,
                  false,
                  MouseEvent.BUTTON1));
        }
        return;
      }
    }
    throw new AssertionError("the palette has no " + kind);
  }

  /** Waits until the script is that of the tree. */
  private void checked() throws InterruptedException, InvocationTargetException {
    CountDownLatch done = new CountDownLatch(1);
    EventQueue.invokeAndWait(() -> program().whenChecked(done::countDown));
    done.await();
  }

  @Test
  void clicksOnThePaletteBuildAProgramThatCanBeUndone()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          click("MoveJ");
          click("Wait");
          assertEquals("MoveJ .Waypoint_1 .Wait: 0.01", tree());
          workbench.run("tree.undo");
          assertEquals("MoveJ .Waypoint_1", tree());
          workbench.run("tree.redo");
          assertEquals("MoveJ .Waypoint_1 .Wait: 0.01", tree());
        });
  }

  @Test
  void whatHasToBeCompletedIsInSightAboveTheListOfIt()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          for (int i = 0; i < 40; i++) {
            click("Wait");
          }
          click("If");
        });
    checked();
    EventQueue.invokeAndWait(() -> view.whenReady(document, () -> {}));
    checked();
    EventQueue.invokeAndWait(frame::validate);
    EventQueue.invokeAndWait(
        () -> {
          JList<?> rows = find(frame, "program-tree", JList.class);
          int chosen = rows.getMinSelectionIndex();
          assertTrue(
              rows.getVisibleRect().contains(rows.getCellBounds(chosen, chosen)),
              "row " + chosen + " is out of sight");
        });
  }

  @Test
  void thePaletteShowsWhatIsLookedFor() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          JTextField search = find(frame, "program-palette-search", JTextField.class);
          search.setText("pall");
          assertEquals(2, find(frame, "program-palette", JList.class).getModel().getSize());
        });
  }

  @Test
  void breakpointsOfTheTreeAreThoseOfTheScriptAndGoAlongWithTheirNodes()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          click("Halt");
          workbench.run("tree.breakpoint");
        });
    checked();
    int[] line = {0};
    CountDownLatch set = new CountDownLatch(1);
    EventQueue.invokeAndWait(
        () -> {
          line[0] = editor.breakpoints(document).first();
          assertTrue(document.script().text().lines().toList().get(line[0] - 1).contains("halt"));
          TreeList list = find(frame, "program-tree", TreeList.class);
          list.select(Trees.MAIN);
          program()
              .change(
                  "Add",
                  0,
                  program().tree().insert(Trees.MAIN, 0, List.of(Trees.comment("above"))));
          program().whenChecked(set::countDown);
        });
    set.await();
    EventQueue.invokeAndWait(
        () -> {
          int now = editor.breakpoints(document).first();
          assertTrue(now > line[0], now + " is not below " + line[0]);
          assertTrue(document.script().text().lines().toList().get(now - 1).contains("halt"));
        });
  }

  @Test
  void whatIsNotCompleteKeepsTheProgramFromRunning()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(() -> click("MoveJ"));
    checked();
    EventQueue.invokeAndWait(
        () -> {
          JList<?> problems = find(frame, "program-problems", JList.class);
          assertEquals(1, problems.getModel().getSize());
        });
  }

  @Test
  void whatIsNotCompleteCanBeReadAfterAChangeOfTheTheme()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(() -> click("MoveJ"));
    checked();
    EventQueue.invokeAndWait(
        () -> {
          look.setTheme(Theme.DARK);
          assertEquals(List.of(), Contrast.hardToRead(view.component()));
          look.setTheme(Theme.LIGHT);
          assertEquals(List.of(), Contrast.hardToRead(view.component()));
        });
  }

  @Test
  void rowsAreReadOut() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          click("Folder");
          TreeList list = find(frame, "program-tree", TreeList.class);
          Component cell =
              list.getCellRenderer()
                  .getListCellRendererComponent(
                      list, list.getModel().getElementAt(1), 1, true, true);
          String said = ((JLabel) cell).getText();
          assertTrue(said.startsWith("Line 2, ") && said.contains("level 2"), said);
        });
  }

  @Test
  void aTextThatIsNoTreeIsShownAsText() throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          document.setText(document.text() + "  nonsense\n");
          assertTrue(find(frame, "program-text-pane", TextPane.class).isShowing());
          assertEquals(1, find(frame, "program-text-problems", JList.class).getModel().getSize());
        });
  }

  @Test
  void theCaretOfTheScriptSelectsTheNodeAndBack()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          click("Folder");
          click("Halt");
        });
    checked();
    EventQueue.invokeAndWait(
        () -> {
          TreeList list = find(frame, "program-tree", TreeList.class);
          view.refresh(workbench.session().state());
          list.select(Trees.MAIN);
          int main = editor.caretLine();
          long halt = program().tree().nodes().getLast().key();
          int place = program().script().of(halt).orElseThrow().first();
          editor.show(place - 1, 1);
          view.refresh(workbench.session().state());
          assertEquals(List.of(halt), List.copyOf(list.selected()));
          list.select(Trees.MAIN);
          assertEquals(main, editor.caretLine());
          editor.show(1, 1);
          view.refresh(workbench.session().state());
          assertEquals(List.of(Trees.MAIN), List.copyOf(list.selected()));
          editor.show(place, 1);
          view.refresh(workbench.session().state());
          assertEquals(List.of(halt), List.copyOf(list.selected()));
        });
  }
}
