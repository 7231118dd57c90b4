package org.pendant.kit.action;

import java.util.List;

/** Actions of the window, all of them; keys can be changed by people. */
public interface Actions {

  /**
   * Adds an action.
   *
   * @throws IllegalArgumentException if there is one of this id already
   */
  void add(Action action);

  /** All of them, in the order they were added. */
  List<Action> all();

  /** Does one, if it is enabled now. */
  void run(String id);

  /** The key that does it now, people's choice first; empty for none. */
  String keysOf(String id);
}
