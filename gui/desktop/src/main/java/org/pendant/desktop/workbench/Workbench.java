package org.pendant.desktop.workbench;

import java.nio.file.Path;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.Settings;

/** Workbench: what views may use of the window around them. Only the dispatch thread calls it. */
public interface Workbench {

  /** The controller that is worked with. */
  RobotSession session();

  /** Everything that can be done by key, menu or palette. */
  ActionTable actions();

  /** What is remembered from one start to the next. */
  Settings settings();

  /** Brings a view to the front. */
  void show(String viewId);

  /** Shows a place of the open program; lines count from 1. */
  void showSource(int line, int column);

  /** The files of the programs and the installation that are open; nothing is exported to them. */
  List<Path> openFiles();

  /**
   * A file called {@code name} where people export to at first: beside the program, else where
   * files were opened last.
   */
  Path exportFile(String name);

  /** Tells something at the edge of the window, without stopping the user. */
  default void notify(String text) {
    notify(text, () -> true);
  }

  /** As the other one, and takes it back as soon as {@code holds} says that it is no longer so. */
  void notify(String text, BooleanSupplier holds);
}
