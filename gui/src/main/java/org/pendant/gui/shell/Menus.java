package org.pendant.gui.shell;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.KeyStroke;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import org.pendant.gui.layout.WrappingRow;
import org.pendant.gui.shell.bar.ActionItem;
import org.pendant.gui.shell.bar.ProgramMenu;
import org.pendant.gui.workbench.Action;
import org.pendant.gui.workbench.ActionTable;

/** The menu bar, made from the actions: the begin of an action's id says in which menu it is. */
final class Menus {
  /** The menus; the last one takes the actions that no other takes. */
  private static final List<Group> GROUPS =
      List.of(
          new Group("File", List.of("file")),
          new Group("Edit", List.of("edit", "editor", "script")),
          new Group("View", List.of("view", "dock", "look")),
          new Group("Program", List.of("program", "debug")),
          new Group("Robot", List.of("robot", "speed", "clock", "move", "scene")),
          new Group("Tools", List.of()));

  /**
   * A menu.
   *
   * @param prefixes of the ids of its actions
   */
  private record Group(String title, List<String> prefixes) {}

  private final ActionTable actions;
  private final JMenuBar bar = new JMenuBar();
  private final Supplier<List<Path>> recent;
  private final Consumer<Path> open;

  Menus(ActionTable actions, Supplier<List<Path>> recent, Consumer<Path> open) {
    this.actions = actions;
    this.recent = recent;
    this.open = open;
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
      menu.addMenuListener(new Opening(() -> fill(menu, group.prefixes())));
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

  private static String group(Action action) {
    int dot = action.id().indexOf('.');
    return dot < 0 ? action.id() : action.id().substring(0, dot);
  }

  private static boolean known(String group) {
    return GROUPS.stream().anyMatch(each -> each.prefixes().contains(group));
  }

  private void fill(JMenu menu, List<String> groups) {
    menu.removeAll();
    String before = "";
    for (String wanted : groups.isEmpty() ? others() : groups) {
      List<Action> members =
          actions.all().stream().filter(each -> group(each).equals(wanted)).toList();
      if (!before.isEmpty() && !members.isEmpty()) {
        menu.addSeparator();
      }
      members.forEach(each -> menu.add(ActionItem.of(actions, each.id())));
      before = members.isEmpty() ? before : wanted;
    }
    if (groups.contains("file")) {
      addRecent(menu);
    }
  }

  private List<String> others() {
    return actions.all().stream().map(Menus::group).filter(g -> !known(g)).distinct().toList();
  }

  private void addRecent(JMenu menu) {
    List<Path> files = recent.get();
    JMenu list = new JMenu("Recent");
    list.setName("menu-recent");
    list.setEnabled(!files.isEmpty());
    for (Path file : files) {
      list.add(ProgramMenu.recentItem(file, open));
    }
    menu.insert(list, Math.min(2, menu.getItemCount()));
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
