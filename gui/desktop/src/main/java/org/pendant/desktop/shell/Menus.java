package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import org.pendant.desktop.shell.MenuPlan.Entry;
import org.pendant.desktop.shell.chrome.ProgramMenu;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionItem;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.layout.WrappingRow;

/** Menu bar: the actions, each where {@link MenuPlan} has it. */
final class Menus {
  private final ActionTable actions;
  private final JMenuBar bar = new JMenuBar();
  private final List<MenuPlan.Menu> plan;
  private final Map<String, Supplier<List<JMenuItem>>> files;

  /**
   * The menus; those for programs made of nodes are hidden.
   *
   * @param files the items that are no actions, by the title of their entry in the plan
   */
  Menus(
      ActionTable actions, List<MenuPlan.Menu> plan, Map<String, Supplier<List<JMenuItem>>> files) {
    this.actions = actions;
    this.plan = plan;
    this.files = Map.copyOf(files);
    // Wraps where the window is too narrow for all menus.
    bar.setLayout(new WrappingRow(0));
    // Filled when they open. Items that stay would do actions by keys that these had once.
    actions.addListener(this::empty);
    // F10 would open the menus; Alt does too.
    bar.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke("F10"), "none");
    for (MenuPlan.Menu each : plan) {
      JMenu menu = menu("menu", each.word(), each.title());
      menu.setMnemonic(each.title().charAt(0));
      menu.addMenuListener(new Opening(() -> new Sorted().fill(menu, each.entries(), "")));
      bar.add(menu);
    }
    showFor(false);
  }

  /** Items that open files. */
  static List<JMenuItem> items(List<Path> recent, Consumer<Path> open) {
    return recent.stream().map(file -> ProgramMenu.recentItem(file, open)).toList();
  }

  JMenuBar bar() {
    return bar;
  }

  /** Shows the menus for a program that is made of nodes, or for a script. */
  void showFor(boolean tree) {
    Sorted sorted = new Sorted();
    for (int i = 0; i < plan.size(); i++) {
      MenuPlan.Menu each = plan.get(i);
      bar.getMenu(i).setVisible((tree || !each.forTrees()) && sorted.hasAny(each.entries()));
    }
  }

  private void empty() {
    for (int i = 0; i < bar.getMenuCount(); i++) {
      bar.getMenu(i).removeAll();
    }
  }

  private static JMenu menu(String parent, String word, String title) {
    JMenu menu = new JMenu(title);
    menu.setName(parent + "-" + word);
    return menu;
  }

  /** Where the actions are that the window has now. */
  private final class Sorted {
    private final Map<Entry.Rest, List<String>> rests =
        MenuPlan.sorted(plan, actions.all().stream().map(Action::id).toList());

    boolean hasAny(List<Entry> entries) {
      return entries.stream()
          .anyMatch(
              entry ->
                  switch (entry) {
                    case Entry.Rest rest -> rests.containsKey(rest);
                    case Entry.One one -> one.ids().stream().anyMatch(this::exists);
                    case Entry.Sub sub -> hasAny(sub.entries());
                    case Entry.Files each -> !files.get(each.title()).get().isEmpty();
                    case Entry.Places places -> !places.views().isEmpty();
                    case Entry.Line _ -> false;
                  });
    }

    private boolean exists(String id) {
      return actions.find(id).isPresent();
    }

    /** Lines only between entries. */
    void fill(JMenu menu, List<Entry> entries, String said) {
      menu.removeAll();
      boolean line = false;
      for (Entry entry : entries) {
        if (entry instanceof Entry.Line) {
          line = menu.getItemCount() > 0;
          continue;
        }
        List<JMenuItem> items = items(menu, entry, said);
        if (line && !items.isEmpty()) {
          menu.addSeparator();
          line = false;
        }
        items.forEach(menu::add);
      }
    }

    private List<JMenuItem> items(JMenu menu, Entry entry, String said) {
      return switch (entry) {
        case Entry.Rest rest ->
            rests.getOrDefault(rest, List.of()).stream()
                .map(id -> ActionItem.of(actions, id, said))
                .toList();
        case Entry.One one -> one(one.ids()).map(id -> ActionItem.of(actions, id)).toList();
        case Entry.Sub sub -> hasAny(sub.entries()) ? List.of(sub(menu, sub)) : List.of();
        case Entry.Files each -> files.get(each.title()).get();
        case Entry.Places places -> List.of(places(menu, places));
        case Entry.Line _ -> List.of();
      };
    }

    private Stream<String> one(List<String> ids) {
      List<String> there = ids.stream().filter(this::exists).toList();
      return there.stream()
          .filter(id -> actions.find(id).orElseThrow().enabled().getAsBoolean())
          .findFirst()
          .or(() -> there.stream().findFirst())
          .stream();
    }

    private JMenu sub(JMenu parent, Entry.Sub entry) {
      JMenu menu = menu(parent.getName(), entry.word(), entry.title());
      fill(menu, entry.entries(), entry.said());
      return menu;
    }

    private JMenu places(JMenu parent, Entry.Places entry) {
      JMenu all = menu(parent.getName(), entry.word(), entry.title());
      for (String view : entry.views()) {
        String title = ActionItem.of(actions, "view." + view, text("show")).getText();
        JMenu menu = new JMenu(title);
        String begin = MenuPlan.ARRANGE + view + "-";
        actions.all().stream()
            .map(Action::id)
            .filter(id -> id.startsWith(begin))
            .forEach(id -> menu.add(ActionItem.of(actions, id, text("move", title))));
        all.add(menu);
      }
      return all;
    }
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
