package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

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
      add(menu, text("addBreakpoint"), () -> breakpoints.toggle(line));
      add(menu, text("addConditionalBreakpoint"), () -> editCondition.accept(line));
      add(menu, text("addLogpoint"), () -> editMessage.accept(line));
      return menu;
    }
    Breakpoint breakpoint = there.get();
    boolean logs = breakpoint.logs();
    add(
        menu,
        text(logs ? "removeLogpoint" : "removeThisBreakpoint"),
        () -> breakpoints.toggle(line));
    add(
        menu,
        breakpoint.enabled()
            ? text(logs ? "disableLogpoint" : "disableBreakpoint")
            : text(logs ? "enableLogpoint" : "enableBreakpoint"),
        () -> breakpoints.change(breakpoint.enabled(!breakpoint.enabled())));
    menu.addSeparator();
    add(menu, text("editCondition"), () -> editCondition.accept(line));
    add(menu, text("editLogMessage"), () -> editMessage.accept(line));
    return menu;
  }

  private static void add(JPopupMenu menu, String title, Runnable run) {
    JMenuItem item = new JMenuItem(title);
    item.addActionListener(event -> run.run());
    menu.add(item);
  }
}
