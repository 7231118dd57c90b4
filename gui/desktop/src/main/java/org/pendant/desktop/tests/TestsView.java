package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ThreadLocalRandom;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JRootPane;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.debug.RunScript;
import org.pendant.desktop.editor.ScriptEditor;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.background.Background;
import org.pendant.kit.layout.CodeArea;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.HtmlLabel;
import org.pendant.kit.theme.Markup;
import org.pendant.kit.theme.Palette;
import org.pendant.testing.TestId;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.source.TestCase;

/**
 * Tests view: the tests beside the program in front, and what came of them. They run in controllers
 * of their own, never in the one of the window.
 */
public final class TestsView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "tests";

  private static final double SHARE = 0.55;

  /** Where the panel is low, names of tests need as much room as what came of one. */
  private static final double LOW_SHARE = 0.5;

  private static final int MAX_SEED = 1_000_000;

  private final Workbench workbench;
  private final OpenFolder folder;
  private final TestsPresenter presenter;
  private final TestsTree tree;
  private final JTextArea details = new CodeArea();
  private final JPanel found = new JPanel(new BorderLayout());
  private final GoldenCard golden;
  private final JSplitPane split = new JSplitPane();
  private final JLabel summary = new JLabel(" ");
  private final JLabel note = new HtmlLabel(SwingConstants.CENTER);
  private final JCheckBox coverage = new JCheckBox(text("coverage"));
  private final CoverStrip strip;
  private final JButton runAll =
      button("run-all", text("runAll"), text("runsAllTestsBelowTheFolder"));
  private final JButton runSelected =
      button("run-selected", text("runSelected"), text("runsTheSelectedTestsAndFiles"));
  private final JButton debug = button("debug", text("debug"), text("runsTheSelectedTestInThe"));
  private final JButton write = button("from-run", text("fromLastRun"), "");
  private final JButton stop = button("stop", text("stop"), text("endsTheTestsThatRunNo"));
  private final CardLayout cards = new CardLayout();
  private final JPanel middle = new JPanel(cards);
  private final JPanel content = new JPanel(new BorderLayout());
  private long shown = -1;
  private Supplier<String> whyNotWrite = () -> "";
  private Optional<TestId> toRun = Optional.empty();
  private Optional<TestId> toChoose = Optional.empty();
  private Optional<TestCase> debugged = Optional.empty();
  private boolean ran;
  private boolean arranged;
  private final TestCommands commands;

  /**
   * The panel; it adds its actions to the workbench.
   *
   * @param starts told before a test that is debugged, or the program of one, starts
   */
  public TestsView(
      Workbench workbench,
      Programs programs,
      ScriptEditor editor,
      ActiveInstallation installation,
      BiConsumer<ProgramDocument, RunScript> starts) {
    this.workbench = workbench;
    folder = new OpenFolder(programs, workbench.session(), installation, this::knows);
    presenter =
        new TestsPresenter(
            folder::setup,
            Background::run,
            EventQueue::invokeLater,
            () -> ThreadLocalRandom.current().nextInt(1, MAX_SEED),
            this::covers);
    strip = new CoverStrip(programs, this::covers, this::reached, editor::showCover);
    tree = new TestsTree(presenter);
    TestDebugger debugger =
        new TestDebugger(workbench.session(), programs, starts, workbench::notify, presenter::ran);
    golden =
        new GoldenCard(() -> tree.selectedTest().ifPresent(test -> presenter.record(test.id())));
    commands =
        new TestCommands(workbench, programs, editor, presenter, tree, strip, debugger, golden);
    content.setName("tests-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(bar(), BorderLayout.NORTH);
    content.add(middle);
    middle.add(parts(), "tests");
    middle.add(empty(), "empty");
    listen();
    commands.addActions();
    commands.whenChanged(this::show);
    show();
  }

  /**
   * Has a button write a test from the last run.
   *
   * @param whyNot why that cannot be done now; empty if it can
   */
  public void writeTestBy(Supplier<String> whyNot, Runnable written) {
    whyNotWrite = whyNot;
    write.addActionListener(event -> written.run());
    showWrite();
  }

  private void showWrite() {
    String why = whyNotWrite.get();
    write.setEnabled(why.isEmpty());
    write.setToolTipText(why.isEmpty() ? text("writesATestThatRepeatsThe") : why);
  }

  /**
   * Shows a test that has just been written and runs it, where its file belongs to those that the
   * panel shows.
   */
  public void showNew(Path file, String function) {
    Optional<Path> where = presenter.setup().map(each -> Path.of(each.files().folder()));
    Path absolute = file.toAbsolutePath().normalize();
    toRun =
        where
            .filter(absolute::startsWith)
            .map(each -> each.relativize(absolute).toString().replace('\\', '/'))
            .map(name -> new TestId(name, function, ""));
    toRun.ifPresent(_ -> workbench.show(ID));
  }

  /** Runs what was just written as soon as nothing else runs, and selects it when it is there. */
  private void followNew() {
    if (toRun.isPresent() && !presenter.running() && !presenter.looking()) {
      presenter.run(Set.copyOf(toRun.stream().toList()));
      toChoose = toRun;
      toRun = Optional.empty();
    }
    if (toChoose.isPresent()
        && presenter.files().stream().anyMatch(file -> file.name().equals(toChoose.get().file()))) {
      show();
      toChoose.ifPresent(tree::choose);
      toChoose = Optional.empty();
    }
  }

  private boolean covers() {
    return TestCommands.covers(workbench.settings());
  }

  private Optional<CoverStrip.Reached> reached(ProgramDocument program) {
    return program.file().flatMap(each -> presenter.reached(each.toAbsolutePath().normalize()));
  }

  private boolean knows(String name) {
    return presenter.knows(name);
  }

  private static JButton button(String name, String text, String tip) {
    JButton button = new JButton(text);
    button.setName("tests-" + name);
    button.setToolTipText(tip);
    return button;
  }

  private JPanel bar() {
    JPanel bar = new JPanel(new WrappingRow(6));
    summary.setName("tests-summary");
    bar.add(runAll);
    bar.add(runSelected);
    bar.add(debug);
    bar.add(write);
    bar.add(stop);
    bar.add(coverage);
    bar.add(summary);
    return bar;
  }

  private JComponent parts() {
    details.setName("tests-details");
    details.getAccessibleContext().setAccessibleName(text("whatCameOfTheSelectedTest"));
    details.setEditable(false);
    details.setLineWrap(true);
    details.setWrapStyleWord(true);
    details.setBorder(BorderFactory.createEmptyBorder(6, 8, 6, 8));
    JScrollPane left = new JScrollPane(tree);
    JScrollPane right = new JScrollPane(details);
    left.setBorder(BorderFactory.createEmptyBorder());
    right.setBorder(BorderFactory.createEmptyBorder());
    split.setName("tests-split");
    split.setBorder(BorderFactory.createEmptyBorder());
    split.setLeftComponent(left);
    found.add(right);
    found.add(golden, BorderLayout.SOUTH);
    split.setRightComponent(found);
    split.setResizeWeight(SHARE);
    split.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            arrange();
          }
        });
    return split;
  }

  /** What came of a test is below the tree; beside it where the panel is low. */
  private void arrange() {
    int wanted =
        split.getWidth() > 2 * split.getHeight()
            ? JSplitPane.HORIZONTAL_SPLIT
            : JSplitPane.VERTICAL_SPLIT;
    if (!arranged || split.getOrientation() != wanted) {
      arranged = true;
      boolean low = wanted == JSplitPane.HORIZONTAL_SPLIT;
      found.add(golden, low ? BorderLayout.LINE_END : BorderLayout.SOUTH);
      split.setOrientation(wanted);
      split.setDividerLocation(low ? LOW_SHARE : SHARE);
    }
  }

  private JPanel empty() {
    JPanel panel =
        new JPanel(new MigLayout("insets 12, wrap 1, align center center", "[center, grow]"));
    note.setName("tests-note");
    JButton help = button("help", text("howToWriteTests"), text("opensTheDocumentationOfTests"));
    help.addActionListener(event -> workbench.actions().run("help.tests"));
    panel.add(note, "growx, wmin 0");
    panel.add(help);
    return panel;
  }

  private void listen() {
    stop.getAccessibleContext().setAccessibleName(text("stopTheTests"));
    runAll.addActionListener(event -> commands.runAll());
    runSelected.addActionListener(event -> commands.runSelected());
    debug.addActionListener(event -> commands.debug());
    stop.addActionListener(event -> commands.stop());
    coverage.setName("tests-coverage");
    coverage.setToolTipText(text("countsWhatTestsReachOfPrograms"));
    coverage.addActionListener(event -> commands.turnCoverage());
    tree.addTreeSelectionListener(event -> show());
    key("ENTER", commands::open);
    key("control ENTER", commands::runSelected);
    key("control shift ENTER", commands::debug);
    key("CONTEXT_MENU", this::menuAtSelection);
    key("shift F10", this::menuAtSelection);
    tree.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2 && tree.onRow(event)) {
              commands.open();
            }
          }

          @Override
          public void mousePressed(MouseEvent event) {
            menu(event);
          }

          @Override
          public void mouseReleased(MouseEvent event) {
            menu(event);
          }

          private void menu(MouseEvent event) {
            if (event.isPopupTrigger() && tree.onRow(event)) {
              tree.chooseAt(event);
              commands.menu().show(tree, event.getX(), event.getY());
            }
          }
        });
  }

  private void menuAtSelection() {
    Rectangle row = tree.getRowBounds(tree.getLeadSelectionRow());
    if (row != null) {
      commands.menu().show(tree, row.x, row.y + row.height);
    }
  }

  private void key(String keys, Runnable run) {
    tree.registerKeyboardAction(
        event -> run.run(), KeyStroke.getKeyStroke(keys), JComponent.WHEN_FOCUSED);
  }

  private void show() {
    shown = presenter.changes();
    debugged = commands.debugging();
    tree.refresh();
    boolean there = !presenter.files().isEmpty();
    if (!there) {
      note.setText("<html><center>" + Markup.escaped(TestWords.empty(presenter)));
      note.setForeground(Palette.quiet());
    }
    showCard(there);
    boolean over = ran && !presenter.running();
    ran = presenter.running();
    if (over) {
      if (tree.front().isEmpty()) {
        presenter.firstRed().ifPresent(tree::choose);
      }
    }
    summary.setText(
        commands
            .debugging()
            .map(test -> text("debugging", test.id().name()))
            .orElse(there || presenter.running() ? TestWords.summary(presenter) : " "));
    String more = TestWords.more(presenter);
    summary.setToolTipText(more.isEmpty() ? null : more);
    summary.setForeground(
        presenter.firstRed().isPresent() && !presenter.running()
            ? Palette.error()
            : Palette.quiet());
    runAll.setEnabled(presenter.canRun());
    runSelected.setEnabled(presenter.canRun() && !tree.chosenTests().isEmpty());
    coverage.setSelected(covers());
    debug.setEnabled(commands.canDebug());
    stop.setVisible(presenter.running() || commands.debugging().isPresent());
    stop.setEnabled(!presenter.stopping());
    showDetails();
  }

  /** Keys that went to the panel while it was empty go to the tree from then on. */
  private void showCard(boolean tests) {
    boolean came = tests && !tree.isShowing();
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    boolean within = owner != null && SwingUtilities.isDescendingFrom(owner, content);
    cards.show(middle, tests ? "tests" : "empty");
    if (came && within) {
      tree.requestFocusInWindow();
    }
  }

  private void showDetails() {
    String text =
        tree.front()
            .map(
                each ->
                    switch (each) {
                      case TestCase test -> TestWords.details(presenter, test);
                      case FoundFile file -> TestWords.details(file);
                      case CoverageReport report -> CoverageWords.details(report);
                      case CoveredFile file -> CoverageWords.details(file);
                      default -> TestWords.overview(presenter);
                    })
            .orElseGet(() -> TestWords.overview(presenter));
    Optional<TestId> test = tree.selectedTest().map(TestCase::id);
    golden.show(
        test,
        GoldenOffer.of(test.flatMap(presenter::result)),
        test.flatMap(presenter::difference),
        presenter.canRun());
    if (!text.equals(details.getText())) {
      details.setText(text);
      details.setCaretPosition(0);
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("tests");
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    if (folder.changed(presenter.folder(), presenter.running())) {
      presenter.look();
    }
    showWrite();
    followNew();
    if (shown != presenter.changes() || !debugged.equals(commands.debugging())) {
      show();
    }
    takeFocus();
  }

  /** What shows the panel gives the focus to what is around it while there is no test yet. */
  private void takeFocus() {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    if (tree.isShowing() && isAround(owner, content)) {
      tree.requestFocusInWindow();
    }
  }

  /** Whether keys go to a view or to what it lies in; those of an open menu go to the root pane. */
  static boolean isAround(Component owner, Component view) {
    return owner instanceof JComponent
        && !(owner instanceof JRootPane)
        && SwingUtilities.isDescendingFrom(view, owner);
  }

  /** Whether a test has the robot of the window. */
  public boolean debugging() {
    return commands.debugging().isPresent();
  }

  /** Shows coverage beside the lines of scripts, whether or not the panel is visible. */
  public void follow() {
    strip.refresh();
  }
}
