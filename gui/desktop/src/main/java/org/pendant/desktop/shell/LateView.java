package org.pendant.desktop.shell;

import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JComponent;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.View;

/**
 * Late view: one that is made when it is first shown, as a start need not wait for it. It is for
 * views that add no actions and hear of nothing that they could not ask for later.
 */
final class LateView implements View {
  private final String id;
  private final String title;
  private final Supplier<View> maker;
  private Optional<View> made = Optional.empty();

  LateView(String id, String title, Supplier<View> maker) {
    this.id = id;
    this.title = title;
    this.maker = maker;
  }

  @Override
  public String id() {
    return id;
  }

  @Override
  public String title() {
    return title;
  }

  @Override
  public JComponent component() {
    return view().component();
  }

  @Override
  public void refresh(ControllerState state) {
    view().refresh(state);
  }

  private View view() {
    if (made.isEmpty()) {
      made = Optional.of(maker.get());
    }
    return made.get();
  }
}
