package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.JComponent;
import org.pendant.desktop.lines.MotionView;
import org.pendant.desktop.timeline.TimelineView;
import org.pendant.desktop.whatif.WhatIfView;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.dock.DockFrame;
import org.pendant.kit.dock.Dockable;
import org.pendant.kit.dock.Side;
import org.pendant.kit.find.CommandPalette;
import org.pendant.kit.find.KeyEditor;
import org.pendant.kit.theme.Look;
import org.pendant.kit.theme.Theme;

/** Window actions: those for views, docks, the look, and finding actions. */
final class WindowActions {
  private final ActionTable actions;

  WindowActions(ActionTable actions) {
    this.actions = actions;
  }

  /** Showing a screen with alt and a digit, and the other views. */
  void addViews(DockFrame docks, List<String> screens) {
    for (Dockable view : docks.views()) {
      int number = screens.indexOf(view.id()) + 1;
      String keys = number >= 1 && number <= 9 ? "alt " + number : keysOf(view);
      Action show =
          Action.of(
                  "view." + view.id(),
                  text("showView", view.title()),
                  keys,
                  () -> docks.show(view.id()))
              .foundBy(words(view.id()));
      actions.add(
          number >= 1 ? show.chosen(() -> docks.mainView().equals(Optional.of(view.id()))) : show);
    }
  }

  /** Other words by which people look for a view. */
  private static String words(String view) {
    return switch (view) {
      case MotionView.ID -> text("wordsForMotion");
      case TimelineView.ID -> text("wordsForTimeline");
      case WhatIfView.ID -> text("wordsForWhatIf");
      default -> "";
    };
  }

  private static String keysOf(Dockable panel) {
    return panel.id().equals(TimelineView.ID) ? "control alt T" : "";
  }

  /** Moving views, and folding docks. */
  void addDocks(DockFrame docks) {
    for (Side side : List.of(Side.LEFT, Side.RIGHT, Side.LOWER, Side.BOTTOM)) {
      String key =
          switch (side) {
            case LEFT -> "control shift B";
            case RIGHT -> "control B";
            case LOWER -> "control alt J";
            case BOTTOM, MAIN, WINDOW -> "control J";
          };
      actions.add(
          Action.of(
                  "dock.fold-" + side.word(),
                  text("showTheDockAt", side.title()),
                  key,
                  () -> docks.toggle(side))
              .checked(() -> !docks.collapsed(side)));
    }
    actions.add(Action.of("dock.reset", text("putAllPanelsWhereTheyBelong"), "", docks::reset));
    for (Dockable view : docks.views()) {
      for (Side side : Side.values()) {
        actions.add(
            Action.of(
                    "arrange." + view.id() + "-" + side.word(),
                    text("moveTo", view.title(), side.title()),
                    "",
                    () -> docks.move(view.id(), side))
                .chosen(() -> docks.sideOf(view.id()) == side));
      }
    }
  }

  /** Colours and scale. */
  void addLook(Look look) {
    for (Theme theme : Theme.values()) {
      actions.add(
          Action.of(
                  "look." + theme.word(),
                  text("coloursAre", theme.title()),
                  "",
                  () -> look.setTheme(theme))
              .chosen(() -> look.theme() == theme));
    }
    actions.add(
        Action.of(
            "look.larger", text("everythingLarger"), "control alt EQUALS", () -> look.zoom(1)));
    actions.add(
        Action.of(
            "look.smaller", text("everythingSmaller"), "control alt MINUS", () -> look.zoom(-1)));
    actions.add(
        Action.of(
            "look.normal",
            text("everythingInNormalSize"),
            "control alt 0",
            () -> look.setZoomPercent(100)));
  }

  /**
   * Finding actions, changing their keys, and what the window has told.
   *
   * @param under what panels may cover
   * @param lastNotice the last thing that was told; empty if nothing was
   */
  void addHelp(JComponent under, Notices notices, Supplier<String> lastNotice) {
    CommandPalette palette = new CommandPalette(actions, under);
    KeyEditor keyEditor = new KeyEditor(actions, under);
    actions.add(Action.of("help.palette", text("findAnAction"), "control shift P", palette::open));
    actions.add(Action.of("help.keys", text("changeKeys"), "", keyEditor::open));
    actions.add(
        new Action(
            "help.question",
            text("answerTheQuestionAtTheTop"),
            "control shift E",
            notices::any,
            notices::focus),
        () -> text("thereIsNoQuestion"));
    actions.add(
        new Action(
            "help.notice",
            text("showTheLastNoticeAsA"),
            "",
            () -> !lastNotice.get().isEmpty(),
            () -> notices.tell(Notices.WHOLE, lastNotice.get())),
        () -> text("thereWasNoNotice"));
  }
}
