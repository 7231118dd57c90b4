package org.pendant.command;

import java.util.List;
import org.pendant.controller.state.ControllerState;

/** Frame watchers: several of them look at the same run. */
record FrameWatchers(List<FrameWatcher> all) implements FrameWatcher {
  FrameWatchers {
    all = List.copyOf(all);
  }

  @Override
  public boolean looks() {
    return all.stream().anyMatch(FrameWatcher::looks);
  }

  @Override
  public void see(ControllerState state) {
    all.forEach(each -> each.see(state));
  }

  @Override
  public boolean enough() {
    return all.stream().anyMatch(FrameWatcher::enough);
  }
}
