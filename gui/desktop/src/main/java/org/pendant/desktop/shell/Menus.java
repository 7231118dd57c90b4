package org.pendant.desktop.shell;

import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.KeyStroke;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import org.pendant.desktop.shell.chrome.ProgramMenu;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionItem;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.layout.WrappingRow;

/** Menu bar, made from the actions: the start of an action's id says in which menu it is. */
final class Menus {
  /** What goes where; the last menu takes the actions that no other takes. */
  private static final List<Group> GROUPS =
      List.of(
          new Group("File", List.of("file"), List.of("installation"), List.of("editor.close")),
          new Group(
              "Edit", List.of("edit", "editor", "script"), List.of("editor.fold", "editor.unfold")),
          new Group(
              "Nodes",
              List.of("tree"),
              List.of("tree.find", "tree.palette", "tree.form", "tree.to-tree"),
              List.of("tree.fold", "tree.unfold"),
              List.of("tree.breakpoint", "tree.script", "tree.as-text", "tree.follow")),
          new Group(
              "Go",
              List.of("editor.find", "editor.replace"),
              List.of("editor.definition", "editor.references", "editor.line"),
              List.of("editor.back", "editor.forward", "editor.next", "editor.previous"),
              List.of("editor.open", "editor.symbol", "editor.reopen")),
          new Group(
              "View",
              List.of("view"),
              List.of("dock"),
              List.of("look"),
              List.of("editor.larger", "editor.smaller", "editor.usual-size")),
          new Group("Program", List.of("program"), List.of("debug", "editor.breakpoint")),
          new Group(
              "Robot",
              List.of("robot"),
              List.of("speed"),
              List.of("clock"),
              List.of("move"),
              List.of("scene")),
          new Group("Tools", List.of("")));

  /** Too many for a list: each view has a menu of its own in {@code View}. */
  private static final String ARRANGE = "arrange.";

  /** Too many as well: they are on the Program screen. */
  private static final String ADD = "tree.add-";

  /**
   * A menu.
   *
   * @param sections of it: how the ids of their actions begin
   */
  private record Group(String title, List<List<String>> sections) {
    @SafeVarargs
    @SuppressWarnings("varargs") // only read
    Group(String title, List<String>... sections) {
      this(title, List.of(sections));
    }
  }

  private final ActionTable actions;
  private final JMenuBar bar = new JMenuBar();
  private final Supplier<List<Path>> recent;
  private final Consumer<Path> open;
  private final InstallationFiles installations;

  Menus(
      ActionTable actions,
      Supplier<List<Path>> recent,
      Consumer<Path> open,
      InstallationFiles installations) {
    this.actions = actions;
    this.recent = recent;
    this.open = open;
    this.installations = installations;
    // Wraps where the window is too narrow for all menus.
    bar.setLayout(new WrappingRow(0));
    // Filled when they open. Items that stay would do actions by keys that these had once.
    actions.addListener(this::empty);
    // F10 would open the menus; Alt does too.
    bar.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke("F10"), "none");
    for (Group group : GROUPS) {
      JMenu menu = new JMenu(group.title());
      menu.setName("menu-" + group.title().toLowerCase(Locale.ROOT));
      menu.setMnemonic(group.title().charAt(0));
      menu.addMenuListener(new Opening(() -> fill(menu, group)));
      bar.add(menu);
    }
  }

  JMenuBar bar() {
    return bar;
  }

  private void empty() {
    for (int i = 0; i < bar.getMenuCount(); i++) {
      bar.getMenu(i).removeAll();
    }
  }

  /** How many characters of the id a start explains, whole words only; -1 if it is another one. */
  private static int fit(String id, String begin) {
    boolean fits =
        begin.isEmpty()
            || id.equals(begin)
            || id.startsWith(begin + ".")
            || id.startsWith(begin + "-");
    return fits ? begin.length() : -1;
  }

  private static int fit(String id, List<String> section) {
    return section.stream().mapToInt(begin -> fit(id, begin)).max().orElse(-1);
  }

  /** The section that explains the most of the id. */
  private static List<String> sectionOf(String id) {
    return GROUPS.stream()
        .flatMap(group -> group.sections().stream())
        .max(Comparator.comparingInt(section -> fit(id, section)))
        .orElseThrow();
  }

  private void fill(JMenu menu, Group group) {
    menu.removeAll();
    for (List<String> section : group.sections()) {
      List<String> ids =
          actions.all().stream()
              .map(Action::id)
              .filter(id -> !id.startsWith(ARRANGE) && !id.startsWith(ADD))
              .filter(id -> sectionOf(id).equals(section))
              .toList();
      if (menu.getItemCount() > 0 && !ids.isEmpty()) {
        menu.addSeparator();
      }
      ids.forEach(id -> menu.add(ActionItem.of(actions, id)));
    }
    if (group.title().equals("File")) {
      addRecent(menu, "Recent", Math.min(2, menu.getItemCount()), recent.get(), open);
      addRecent(
          menu,
          "Recent installations",
          menu.getItemCount(),
          installations.recent(),
          installations::open);
    }
    if (group.title().equals("View")) {
      menu.addSeparator();
      menu.add(arrange());
    }
  }

  /** Where each view may go. */
  private JMenu arrange() {
    JMenu all = new JMenu("Move");
    all.setName("menu-arrange");
    Map<String, JMenu> views = new LinkedHashMap<>();
    for (Action each : actions.all()) {
      if (each.id().startsWith(ARRANGE)) {
        String view = each.id().substring(ARRANGE.length(), each.id().lastIndexOf('-'));
        views.computeIfAbsent(view, this::arrange).add(ActionItem.of(actions, each.id()));
      }
    }
    views.values().forEach(all::add);
    return all;
  }

  private JMenu arrange(String view) {
    String show = actions.find("view." + view).map(Action::title).orElse(view);
    return new JMenu(show.replaceFirst("^Show ", ""));
  }

  private static void addRecent(
      JMenu menu, String title, int at, List<Path> files, Consumer<Path> open) {
    JMenu list = new JMenu(title);
    list.setName("menu-" + title.toLowerCase(Locale.ROOT).replace(' ', '-'));
    list.setEnabled(!files.isEmpty());
    for (Path file : files) {
      list.add(ProgramMenu.recentItem(file, open));
    }
    menu.insert(list, at);
  }

  /** Fills a menu each time it opens: actions may have come, and may be enabled now. */
  private record Opening(Runnable fill) implements MenuListener {
    @Override
    public void menuSelected(MenuEvent event) {
      fill.run();
    }

    @Override
    public void menuDeselected(MenuEvent event) {}

    @Override
    public void menuCanceled(MenuEvent event) {}
  }
}
