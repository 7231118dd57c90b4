package org.pendant.desktop.debug;

import java.util.Optional;
import java.util.function.IntConsumer;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.pendant.desktop.editor.MarginMenu;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.script.debug.Breakpoint;

/** Breakpoint menu: what can be done about the breakpoint of a line, where it stands beside it. */
final class BreakpointMenu implements MarginMenu {
  private final OpenBreakpoints breakpoints;
  private final IntConsumer editCondition;
  private final IntConsumer editMessage;

  /**
   * A menu for {@code breakpoints}.
   *
   * @param editCondition has the condition of the breakpoint of a line edited, setting it if needed
   * @param editMessage the same for its message
   */
  BreakpointMenu(OpenBreakpoints breakpoints, IntConsumer editCondition, IntConsumer editMessage) {
    this.breakpoints = breakpoints;
    this.editCondition = editCondition;
    this.editMessage = editMessage;
  }

  @Override
  public JPopupMenu of(ProgramDocument program, int line) {
    JPopupMenu menu = new JPopupMenu();
    menu.setName("margin-menu");
    Optional<Breakpoint> there =
        breakpoints.all(program).stream().filter(each -> each.line() == line).findFirst();
    if (there.isEmpty()) {
      add(menu, "Add breakpoint", () -> breakpoints.toggle(line));
      add(menu, "Add conditional breakpoint\u2026", () -> editCondition.accept(line));
      add(menu, "Add logpoint\u2026", () -> editMessage.accept(line));
      return menu;
    }
    Breakpoint breakpoint = there.get();
    String kind = breakpoint.logs() ? "logpoint" : "breakpoint";
    add(menu, "Remove " + kind, () -> breakpoints.toggle(line));
    add(
        menu,
        (breakpoint.enabled() ? "Disable " : "Enable ") + kind,
        () -> breakpoints.change(breakpoint.enabled(!breakpoint.enabled())));
    menu.addSeparator();
    add(menu, "Edit condition\u2026", () -> editCondition.accept(line));
    add(menu, "Edit log message\u2026", () -> editMessage.accept(line));
    return menu;
  }

  private static void add(JPopupMenu menu, String title, Runnable run) {
    JMenuItem item = new JMenuItem(title);
    item.addActionListener(event -> run.run());
    menu.add(item);
  }
}
