package org.pendant.protocols.server;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * Remote control: whether clients may control the robot. Without the feature all clients may
 * always, and the robot says that it is not in remote control; with it only in remote control. Any
 * thread.
 */
public final class RemoteControl {
  private final boolean enabled;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private volatile boolean remote;

  /**
   * A choice.
   *
   * @param enabled whether there is the feature at all
   * @param remote whether it begins in remote control; counts only with the feature
   */
  public RemoteControl(boolean enabled, boolean remote) {
    this.enabled = enabled;
    this.remote = enabled && remote;
  }

  /** Without the feature. */
  public static RemoteControl disabled() {
    return new RemoteControl(false, false);
  }

  /** Whether there is the feature. */
  public boolean enabled() {
    return enabled;
  }

  /** What clients are told: in remote control or not. */
  public boolean remote() {
    return remote;
  }

  /** Whether a client that connects now may control the robot as long as it stays connected. */
  public boolean mayControl() {
    return !enabled || remote;
  }

  /** The operator switches over; nothing happens without the feature. */
  public void setRemote(boolean wanted) {
    boolean before = remote;
    remote = enabled && wanted;
    if (before && !remote) {
      listeners.forEach(Runnable::run);
    }
  }

  /** Has {@code listener} called when remote control ends. */
  public void onLocal(Runnable listener) {
    listeners.add(listener);
  }
}
