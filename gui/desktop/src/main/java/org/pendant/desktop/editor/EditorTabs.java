package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import com.formdev.flatlaf.FlatClientProperties;
import com.formdev.flatlaf.FlatLaf;
import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntConsumer;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.layout.WholeTabs;

/**
 * Editor tabs: the open programs as tabs. The tab in front is the program that Run runs. At first
 * it is the only one, as making editors takes time: {@link #follow} makes those behind it.
 */
@SuppressWarnings("serial") // never written to a stream
final class EditorTabs extends JTabbedPane {
  /** Marks the program that Run runs. */
  private static final SvgIcon RUNS = SvgIcon.of("mark/run", 12);

  private final Programs programs;
  private final Function<ProgramDocument, ProgramEditor> editors;
  private final Runnable shown;
  private final List<ProgramEditor> open = new ArrayList<>();
  private boolean following;

  /**
   * Tabs that follow {@code programs}.
   *
   * @param editors makes an editor
   * @param closing asked when the user wants to close a tab
   * @param shown told when another tab is in front
   */
  EditorTabs(
      Programs programs,
      Function<ProgramDocument, ProgramEditor> editors,
      Consumer<ProgramEditor> closing,
      Runnable shown) {
    this.programs = programs;
    this.editors = editors;
    this.shown = shown;
    setName("script-tabs");
    getAccessibleContext().setAccessibleName(text("openPrograms"));
    setTabLayoutPolicy(SCROLL_TAB_LAYOUT);
    putClientProperty(FlatClientProperties.TABBED_PANE_TAB_CLOSABLE, true);
    putClientProperty(FlatClientProperties.TABBED_PANE_TAB_CLOSE_TOOLTIPTEXT, "Close");
    IntConsumer close = index -> closing.accept(open.get(index));
    putClientProperty(FlatClientProperties.TABBED_PANE_TAB_CLOSE_CALLBACK, close);
    putClientProperty(FlatClientProperties.TABBED_PANE_HAS_FULL_BORDER, false);
    getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(KeyEvent.VK_TAB, KeyEvent.CTRL_DOWN_MASK), "none");
    programs.addListener(this::follow);
    addChangeListener(event -> chosen());
    following = true;
    insert(programs.current(), 0);
    following = false;
    front();
  }

  /** The editor in front. */
  ProgramEditor current() {
    return open.get(Math.max(0, getSelectedIndex()));
  }

  List<ProgramEditor> all() {
    return List.copyOf(open);
  }

  /** Has a tab for each of the open programs, in their order. */
  void follow() {
    following = true;
    List<ProgramDocument> wanted = programs.all();
    for (int i = open.size() - 1; i >= 0; i--) {
      if (!wanted.contains(open.get(i).program())) {
        removeTabAt(i);
        open.remove(i).end();
      }
    }
    for (int i = 0; i < wanted.size(); i++) {
      if (i == open.size() || open.get(i).program() != wanted.get(i)) {
        insert(wanted.get(i), i);
      }
    }
    setSelectedIndex(wanted.indexOf(programs.current()));
    following = false;
    front();
    // It moved if tabs came before it, and is wider with its icon.
    showSelected();
  }

  private void insert(ProgramDocument program, int index) {
    ProgramEditor editor = editors.apply(program);
    open.add(index, editor);
    insertTab(program.name(), null, editor, null, index);
    program.addListener(
        new ProgramDocument.Listener() {
          @Override
          public void fileChanged() {
            name(editor);
          }
        });
    name(editor);
  }

  private void name(ProgramEditor editor) {
    int index = open.indexOf(editor);
    if (index < 0) {
      return;
    }
    ProgramDocument program = editor.program();
    setTitleAt(index, program.name() + (program.modified() ? " \u2022" : ""));
    boolean runs = index == getSelectedIndex();
    setIconAt(index, runs ? RUNS : null);
    String place = program.file().map(Object::toString).orElse(text("notOnDiskYet"));
    String tip = program.modified() ? text("hasChangesThatAreNotSaved", place) : place;
    setToolTipTextAt(index, runs ? text("runRunsThisProgram", tip) : tip);
  }

  private void chosen() {
    if (!following && getSelectedIndex() >= 0) {
      programs.select(current().program());
      // By arrow keys people go on to the next tab.
      if (!isFocusOwner() || EventQueue.getCurrentEvent() instanceof MouseEvent) {
        validate(); // the pane gives keys to the first button of the tab when it is laid out next
        current().area().requestFocusInWindow();
      }
    }
  }

  @Override
  public void updateUI() {
    if (UIManager.getLookAndFeel() instanceof FlatLaf) {
      setUI(new Tabs());
    } else {
      super.updateUI();
    }
  }

  /** Scrolls the tabs, which may have less room now, so that the one in front is in sight. */
  void showSelected() {
    if (getUI() instanceof Tabs ui) {
      ui.showSelected();
    }
  }

  private static final class Tabs extends WholeTabs {
    void showSelected() {
      ensureSelectedTabIsVisibleLater();
    }
  }

  private void front() {
    open.forEach(this::name);
    open.stream().filter(each -> each != current()).forEach(ProgramEditor::hidePopups);
    shown.run();
  }
}
