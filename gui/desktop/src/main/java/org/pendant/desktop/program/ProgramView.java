package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.EventQueue;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.move.JogHold;
import org.pendant.desktop.program.form.NodeForms;
import org.pendant.desktop.scene.WaypointMarkers;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.check.NodeProblem;

/**
 * Program view: the screen where programs are built as trees: palette, tree, and the form of a
 * node.
 */
public final class ProgramView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "program";

  private static final String EMPTY = "empty";
  private static final String TEXT = "text";
  private static final String TREE = "tree";
  private static final String FOLLOW = "program.follow";

  private final Workbench workbench;
  private final Programs programs;
  private final TreePrograms trees;
  private final ScriptLink link;
  private final Consumer<WaypointMarkers> scene;
  private final CardLayout cards = new CardLayout();
  private final JPanel content = new KeyedPanel(this::perform);
  private final TreeList list = new TreeList();
  private final TreeCommands commands;
  private final ProgramHost host;
  private final TreePane pane;
  private final PalettePanel palette;
  private final ThreeParts parts;
  private final TextPane text;
  private final EmptyPane empty;
  private final ForeignBar foreignBar;
  private final NodeTabs tabs;
  private final JPanel tree = new JPanel(new BorderLayout());
  private final TreeProgram.Listener changes = new Changes();
  private Optional<TreeProgram> program = Optional.empty();
  private boolean asText;
  private Map<Long, List<NodeProblem>> warned = Map.of();
  private boolean follow;
  private boolean fromScript;
  private long followed;
  private PoseForm poseForm = PoseForm.STANDARD;

  /**
   * The screen of the program in front; it adds its actions to the workbench.
   *
   * @param link leads to the script that the tree generates
   * @param teacher where the arm is moved to teach places
   * @param scene shows the places that the program goes to
   */
  public ProgramView(
      Workbench workbench,
      Programs programs,
      TreePrograms trees,
      ScriptLink link,
      ArmTeacher teacher,
      Consumer<WaypointMarkers> scene) {
    assert EventQueue.isDispatchThread();
    this.workbench = workbench;
    this.programs = programs;
    this.trees = trees;
    this.link = link;
    this.scene = scene;
    follow = workbench.settings().get(FOLLOW).map(Boolean::parseBoolean).orElse(true);
    commands = new TreeCommands(new ListSelection(list), new SystemClipboard(), workbench::notify);
    host =
        new ProgramHost(
            workbench,
            teacher,
            new JogHold(workbench.session()::submit, EventQueue::invokeLater),
            list::select,
            () -> shownNode().map(ProgramNode::key).orElse(0L),
            key -> warned.getOrDefault(key, List.of()));
    tabs =
        new NodeTabs(
            new CommandTab(() -> new NodeForms(workbench, host), commands),
            workbench.session().robot().builtins(),
            this::showScript);
    TreeDrag drag = new TreeDrag(list, commands::drop);
    list.mouse().setDrag(drag);
    list.onSelection(this::selectionChanged);
    list.mouse().onOpen(this::focusForm);
    list.onRefusal(workbench::notify);
    list.mouse().onBreakpoint(key -> program.ifPresent(each -> link.toggleBreakpoint(each, key)));
    list.registerKeyboardAction(
        event -> focusForm(), KeyStroke.getKeyStroke("ENTER"), JComponent.WHEN_FOCUSED);
    palette = new PalettePanel(commands::add, commands::make, drag);
    SearchBar search = new SearchBar(this::searched, this::findNext, this::searchEnded);
    IncompleteBar incomplete = new IncompleteBar(this::label, this::goTo);
    pane = new TreePane(list, search, incomplete, workbench.actions(), this::toggleFollow);
    pane.showFollow(follow);
    text = new TextPane(this::showTree);
    empty = new EmptyPane(workbench.actions());
    foreignBar = new ForeignBar(workbench.actions());
    parts = new ThreeParts(palette, pane, tabs, workbench.settings());
    build();
    TreeActions.addTo(workbench.actions(), this, commands);
    programs.addListener(this::programChanged);
    programChanged();
  }

  private void build() {
    content.setName("program-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.setLayout(cards);
    content.add(empty, EMPTY);
    content.add(text, TEXT);
    tree.add(foreignBar, BorderLayout.NORTH);
    tree.add(parts);
    content.add(tree, TREE);
  }

  /** Puts something below tree and node. */
  public void addBelow(JComponent tool) {
    tree.add(tool, BorderLayout.SOUTH);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("program");
  }

  @Override
  public JComponent component() {
    return content;
  }

  /** Lets keys go to the tree, or to the text of a program that is none. */
  public void focus() {
    if (asText) {
      text.focus();
    } else {
      list.requestFocusInWindow();
    }
  }

  // --- the program in front

  private void programChanged() {
    Optional<TreeProgram> next = trees.current();
    if (!next.equals(program)) {
      program.ifPresent(each -> each.removeListener(changes));
      program = next;
      asText = false;
      followed = 0;
      program.ifPresent(each -> each.addListener(changes));
      commands.setProgram(program);
      host.setProgram(program);
      list.setMarks(TreeMarks.NONE);
      list.show(host.tree());
      if (list.selected().isEmpty() && list.getModel().getSize() > 0) {
        list.setSelectedIndex(0);
      }
    }
    showAll();
  }

  private void showAll() {
    if (program.isEmpty()) {
      scene.accept(WaypointMarkers.NONE);
      empty.show(programs.current().name());
      cards.show(content, EMPTY);
      return;
    }
    TreeProgram shown = program.get();
    if (asText || !shown.textProblems().isEmpty()) {
      asText = true;
      text.show(shown);
      cards.show(content, TEXT);
      return;
    }
    cards.show(content, TREE);
    foreignBar.show(shown.document());
    palette.setUsable(commands.editable());
    pane.setEditable(commands.editable());
    if (!shown.tree().equals(list.tree())) {
      list.show(shown.tree());
    }
    showChecked();
    tabs.showVariables(shown);
    searched(pane.search().wanted());
  }

  private void showChecked() {
    list.setLabels(labels());
    program.ifPresent(
        shown -> {
          warned = link.warnings().of(shown);
          list.setProblems(link.warnings().with(shown));
          pane.showProblems(shown.problems());
        });
    showForm();
    showScript();
  }

  private void showForm() {
    scene.accept(
        program
            .map(
                each ->
                    ProgramPlaces.of(each.tree(), each.installation(), list.selected(), poseForm))
            .orElse(WaypointMarkers.NONE));
    tabs.command().show(program, list.selected().size(), shownNode(), list.lead());
  }

  private Optional<ProgramNode> shownNode() {
    Set<Long> selected = list.selected();
    return selected.size() == 1 ? host.tree().find(selected.iterator().next()) : Optional.empty();
  }

  private void showScript() {
    program.ifPresent(each -> tabs.showScript(each.script(), list.lead().orElse(0)));
  }

  private void selectionChanged() {
    showForm();
    showScript();
    if (!fromScript && list.lead().isPresent()) {
      program.ifPresent(each -> link.selected(each, list.lead().getAsLong()));
    }
  }

  private void showTree() {
    asText = false;
    showAll();
    list.requestFocusInWindow();
  }

  void editAsText() {
    asText = true;
    showAll();
  }

  /** Hears of the program in front. */
  private final class Changes implements TreeProgram.Listener {
    @Override
    public void treeChanged() {
      showAll();
    }

    @Override
    public void checked() {
      showChecked();
    }
  }

  @Override
  public void refresh(ControllerState state) {
    host.repeat();
    if (!host.poseForm().equals(poseForm)) {
      poseForm = host.poseForm();
      showForm();
    }
    if (program.isEmpty() || asText) {
      return;
    }
    TreeProgram shown = program.get();
    if (!link.warnings().of(shown).equals(warned)) {
      showChecked();
    }
    TreeMarks marks = link.marks(shown, state);
    list.setMarks(marks);
    if (follow && marks.execution() != 0 && marks.execution() != followed) {
      list.reveal(marks.execution());
    }
    followed = marks.execution();
    OptionalLong caret = link.caretMoved(shown);
    if (caret.isPresent()) {
      fromScript = true;
      list.select(caret.getAsLong());
      fromScript = false;
    }
    tabs.refresh(state, link.execution(shown, state), follow);
  }

  // --- running

  /**
   * Has a program run as soon as it is known that nothing keeps it from that; otherwise shows what
   * does.
   */
  public void whenReady(ProgramDocument document, Runnable run) {
    Optional<TreeProgram> wanted = trees.of(document);
    if (wanted.isEmpty()) {
      run.run();
      return;
    }
    TreeProgram shown = wanted.get();
    if (!shown.textProblems().isEmpty()) {
      workbench.notify(
          text("cannotRunForItsLines", document.name()), () -> !shown.textProblems().isEmpty());
      programs.select(document);
      workbench.show(ID);
      return;
    }
    shown.whenChecked(
        () -> {
          if (shown.problems().isEmpty()) {
            run.run();
          } else {
            block(shown);
          }
        });
  }

  /** The key of the selected node of the program in front; 0 for none. */
  public long selected() {
    return program.isPresent() && !asText ? list.lead().orElse(0) : 0;
  }

  /** Selects a node of the program in front; tells so where that cannot be seen. */
  public void choose(long key) {
    if (program.isEmpty() || asText || host.tree().find(key).isEmpty()) {
      return;
    }
    list.select(key);
    if (!content.isShowing()) {
      workbench.notify(text("isSelectedOnTheProgramScreen", label(key)));
    }
  }

  /** Brings a node of an open program into view and selects it. */
  public void show(RunNode node) {
    programs.select(node.document());
    workbench.show(ID);
    asText = false;
    showAll();
    list.select(node.key());
  }

  private void block(TreeProgram shown) {
    int count = shown.problems().size();
    workbench.notify(
        text(
            count == 1 ? "cannotRunForOneThing" : "cannotRunForThings",
            shown.document().name(),
            count),
        () -> shown.problems().size() == count);
    programs.select(shown.document());
    workbench.show(ID);
    asText = false;
    showAll();
    pane.incomplete().unfold(true);
    content.validate(); // the list takes its room before the node is brought into sight
    goTo(shown.problems().getFirst());
  }

  private String label(long key) {
    return host.tree().find(key).map(node -> labels().of(node.step())).orElse("");
  }

  private NodeLabels labels() {
    return new NodeLabels(host.installation());
  }

  /** Selects a node and puts the keys into the field that has to be changed. */
  private void goTo(NodeProblem problem) {
    list.select(problem.key());
    tabs.focusForm(problem.field());
  }

  /** Adds lines of URScript behind the selected node. */
  public void insertScript(String code) {
    commands.addScript(code);
  }

  /** Selects the node of a line of the generated script. */
  public void showLine(int line) {
    program.flatMap(each -> each.script().at(line)).ifPresent(place -> list.select(place.key()));
  }

  // --- what actions do

  boolean hasProgram() {
    return program.isPresent();
  }

  boolean canEditText() {
    return hasProgram() && !programs.current().readOnly();
  }

  /**
   * Whether keys that delete, copy and the like mean the tree: it has them, or a menu or the
   * palette of actions, which act for it.
   */
  boolean keysMeanTree() {
    return KeyTarget.now(list);
  }

  void toggleFold() {
    list.lead().ifPresent(key -> list.setFolded(key, !list.isFolded(key)));
  }

  void foldAll(boolean wanted) {
    list.foldAll(wanted);
  }

  void rename() {
    if (commands.refused()) {
      return;
    }
    list.lead()
        .ifPresent(
            key ->
                host.tree()
                    .find(key)
                    .flatMap(node -> Renames.nameOf(node.step()))
                    .ifPresentOrElse(
                        name -> pane.rename(key, name, next -> commands.rename(key, next)),
                        () -> workbench.notify(text("nodeHasNoName"))));
  }

  void find() {
    pane.search().open();
  }

  private void searched(String wanted) {
    List<Long> matches = TreeSearch.matches(host.tree(), wanted, labels());
    list.setFound(matches);
    pane.search().showCount(matches.size());
  }

  private void searchEnded() {
    list.setFound(List.of());
    list.requestFocusInWindow();
  }

  void findNext(boolean forward) {
    List<Long> matches = TreeSearch.matches(host.tree(), pane.search().wanted(), labels());
    TreeSearch.next(host.tree(), matches, list.lead().orElse(0), forward).ifPresent(list::select);
  }

  void toggleBreakpoint() {
    program.ifPresent(each -> list.lead().ifPresent(key -> link.toggleBreakpoint(each, key)));
  }

  void focusPalette() {
    parts.showPalette();
    palette.focus();
  }

  void focusForm() {
    tabs.focusForm("");
  }

  void focusTree() {
    list.requestFocusInWindow();
  }

  void showInScript() {
    selectionChanged();
    workbench.actions().run("view.script");
  }

  /** The Script screen closes programs: it asks for what is not saved there. */
  void close() {
    boolean asks = programs.current().modified();
    workbench.actions().run("view.script");
    workbench.actions().run("editor.close");
    if (!asks) {
      workbench.show(ID);
    }
  }

  private boolean perform(KeyStroke stroke) {
    return !asText && TreeActions.perform(workbench.actions(), stroke, keysMeanTree());
  }

  /** Whether the running node is kept in sight. */
  boolean follows() {
    return follow;
  }

  void toggleFollow() {
    follow = !follow;
    workbench.settings().put(FOLLOW, String.valueOf(follow));
    pane.showFollow(follow);
  }
}
