package org.pendant.desktop.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.formdev.flatlaf.FlatClientProperties;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.Box;
import javax.swing.JComponent;
import javax.swing.JTabbedPane;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.desktop.session.ProgramDocument;

/** The tabs of many programs and what stands at their end, such as the debug bar. */
@Tag("slow")
@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class EditorTabsTest {
  /** This tab shows the script of a tree, with buttons above it. */
  private static final int TREE = 2;

  private static final String SCRIPTS = ProgramDocument.SCRIPT;
  private static final String TREES = ProgramDocument.TREE;

  private EditorWindow window;
  private JTabbedPane tabs;

  @BeforeEach
  void openWindow() throws InterruptedException, InvocationTargetException {
    assumeFalse(GraphicsEnvironment.isHeadless(), "a window needs a display");
    List<ProgramDocument> programs =
        IntStream.range(0, 8)
            .mapToObj(
                i -> ProgramDocument.untitled("program_" + i + (i == TREE ? TREES : SCRIPTS), ""))
            .toList();
    EventQueue.invokeAndWait(
        () -> {
          window = EditorWindow.open(false, programs);
          tabs =
              (JTabbedPane)
                  SwingUtilities.getAncestorOfClass(JTabbedPane.class, window.editor().current());
        });
  }

  @AfterEach
  void closeWindow() throws InterruptedException, InvocationTargetException {
    if (window != null) {
      EventQueue.invokeAndWait(window::close);
    }
  }

  @Test
  void keysGoToTheTextOfATabThatIsClicked() throws Exception {
    click(1);
    await(1);
    awaitKeysIn(window.editor().current().area());
  }

  @Test
  void keysGoToTheTextAndNotToTheButtonsAboveItFromAnotherText() throws Exception {
    EventQueue.invokeAndWait(() -> window.editor().current().area().requestFocusInWindow());
    awaitKeysIn(window.editor().current().area());
    click(TREE);
    await(TREE);
    EventQueue.invokeAndWait(tabs::validate);
    awaitKeysIn(window.editor().current().area());
  }

  private void click(int index) throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          Rectangle tab = tabs.getBoundsAt(index);
          Point at = new Point(tab.x + tab.width / 4, tab.y + tab.height / 2);
          tabs.dispatchEvent(
              new MouseEvent(
                  tabs,
                  MouseEvent.MOUSE_PRESSED,
                  0,
                  InputEvent.BUTTON1_DOWN_MASK,
                  at.x,
                  at.y,
                  1,
                  false,
                  MouseEvent.BUTTON1));
        });
  }

  private static void awaitKeysIn(Component component) throws Exception {
    boolean[] there = {false};
    while (!there[0]) {
      EventQueue.invokeAndWait(
          () ->
              there[0] =
                  SwingUtilities.getWindowAncestor(component).getMostRecentFocusOwner()
                      == component);
    }
  }

  @Test
  void theProgramInFrontStaysInSightBesideADebugBarThatComes() throws Exception {
    int last = tabs.getTabCount() - 1;
    EventQueue.invokeAndWait(() -> tabs.setSelectedIndex(last));
    await(last);
    JComponent end =
        (JComponent) tabs.getClientProperty(FlatClientProperties.TABBED_PANE_TRAILING_COMPONENT);
    Container bar = (Container) end.getComponent(0);
    int[] before = {0};
    EventQueue.invokeAndWait(
        () -> {
          before[0] = row().width;
          bar.add(Box.createRigidArea(new Dimension(500, 1)));
          tabs.revalidate();
        });
    boolean[] narrower = {false};
    while (!narrower[0]) {
      EventQueue.invokeAndWait(() -> narrower[0] = row().width < before[0]);
    }
    await(last);
    EventQueue.invokeAndWait(() -> assertTrue(row().contains(tabs.getBoundsAt(last))));
  }

  @Test
  void programsBehindTheOneInFrontComeLaterInTheirOrder() throws Exception {
    List<ProgramDocument> programs =
        Stream.of("a.script", "b.script", "c.script")
            .map(name -> ProgramDocument.untitled(name, "sleep(1)\n"))
            .toList();
    ProgramDocument front = programs.get(1);
    EventQueue.invokeAndWait(
        () -> {
          EditorWindow begun = EditorWindow.begin(false, programs, front);
          ScriptEditor editor = begun.editor();
          tabs =
              (JTabbedPane) SwingUtilities.getAncestorOfClass(JTabbedPane.class, editor.current());
          assertEquals(List.of("b.script"), titles());
          editor.setBreakpointMemory(program -> new TreeSet<>(Set.of(1)));
          editor.openBehind();
          assertEquals(List.of("a.script", "b.script", "c.script"), titles());
          assertEquals(front, editor.current().program());
          programs.forEach(each -> assertEquals(Set.of(1), editor.breakpoints(each)));
          begun.close();
        });
  }

  private List<String> titles() {
    return IntStream.range(0, tabs.getTabCount()).mapToObj(tabs::getTitleAt).toList();
  }

  @Test
  void aTabWithoutRoomIsInTheListOnlyRatherThanThreeDots() throws Exception {
    await(0);
    int[] cut = {0};
    EventQueue.invokeAndWait(
        () -> {
          cut[0] = cut() - 1;
          // the row is to end in the middle of the last tab that was whole, whatever the font
          Rectangle tab = tabs.getBoundsAt(cut[0]);
          int tooWide = row().x + row().width - (tab.x + tab.width / 2);
          Dimension size = window.frame().getSize();
          window.frame().setSize(size.width - tooWide, size.height);
        });
    boolean[] narrower = {false};
    while (!narrower[0]) {
      EventQueue.invokeAndWait(() -> narrower[0] = cut() == cut[0]);
    }
    EventQueue.invokeAndWait(
        () -> {
          BufferedImage picture =
              new BufferedImage(tabs.getWidth(), tabs.getHeight(), BufferedImage.TYPE_INT_RGB);
          Graphics2D pen = picture.createGraphics();
          tabs.paint(pen);
          pen.dispose();
          Rectangle seen = tabs.getBoundsAt(cut()).intersection(row());
          assertTrue(seen.width > 24, () -> "room for dots: " + seen);
          // without the line below the tabs
          seen.height -= 6;
          assertEquals(1, colours(picture, seen), tabs.getTitleAt(cut()));
        });
  }

  /** The first tab that is not seen whole. */
  private int cut() {
    int cut = 0;
    while (row().contains(tabs.getBoundsAt(cut))) {
      cut++;
    }
    return cut;
  }

  private static long colours(BufferedImage picture, Rectangle place) {
    return IntStream.range(place.x, place.x + place.width)
        .flatMap(
            x -> IntStream.range(place.y, place.y + place.height).map(y -> picture.getRGB(x, y)))
        .distinct()
        .count();
  }

  private void await(int index) throws Exception {
    boolean[] seen = {false};
    while (!seen[0]) {
      EventQueue.invokeAndWait(() -> seen[0] = row().contains(tabs.getBoundsAt(index)));
    }
  }

  /** Where tabs are in sight. */
  private Rectangle row() {
    Component row =
        Stream.of(tabs.getComponents())
            .filter(JViewport.class::isInstance)
            .findFirst()
            .orElseThrow();
    return row.getBounds();
  }
}
