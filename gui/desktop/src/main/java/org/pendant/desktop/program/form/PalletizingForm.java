package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.project.program.Identifiers;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.TemplateStep.Palletizing;

/** Palletizing form: that of a pattern of places. */
final class PalletizingForm {
  private static final int CORNERS = 4;

  private PalletizingForm() {}

  static NodeForm of(FormContext context, Palletizing step) {
    Pattern pattern = step.pattern();
    context.kept().keep(pattern);
    FormBuilder form =
        new FormBuilder(context, "palletizing", text("palletizing"), text("goesToTheNextPlaceOf"));
    form.part(text("pallet"))
        .variable(
            "name",
            text("name"),
            step.name(),
            List.of(),
            name -> new Palletizing(name, pattern, step.feature(), step.remember()))
        .quiet("count-hint", TemplateForms.countHint(step.name()))
        .choice(
            "feature",
            text("feature"),
            context.features(),
            step.feature(),
            MotionForms.NO_FEATURE,
            feature -> new Palletizing(step.name(), pattern, feature, step.remember()))
        .check(
            "remember",
            text("keepTheCountForTheNext"),
            step.remember(),
            value -> new Palletizing(step.name(), pattern, step.feature(), value));
    form.part(text("pattern"))
        .sides(
            "pattern",
            text("kind"),
            List.of(
                new Option("line", text("line")),
                new Option("square", text("square")),
                new Option("box", text("box")),
                new Option("places", text("list"))),
            switch (pattern) {
              case Pattern.Line _ -> "line";
              case Pattern.Square _ -> "square";
              case Pattern.Box _ -> "box";
              case Pattern.Places _ -> "places";
            },
            chosen -> with(step, pattern(context.kept(), pattern, chosen)));
    switch (pattern) {
      case Pattern.Line line ->
          form.count(
              NodeFields.LINE_PLACES,
              text("places"),
              line.count(),
              count -> with(step, new Pattern.Line(line.first(), line.last(), count)));
      case Pattern.Square square -> {
        form.count(
            NodeFields.COLUMNS,
            text("inARow"),
            square.columns(),
            count -> with(step, new Pattern.Square(square.corners(), count, square.rows())));
        form.count(
            NodeFields.ROWS,
            text("rows"),
            square.rows(),
            count -> with(step, new Pattern.Square(square.corners(), square.columns(), count)));
      }
      case Pattern.Box box -> {
        form.count(
            NodeFields.COLUMNS,
            text("inARow"),
            box.columns(),
            n -> with(step, new Pattern.Box(box.corners(), n, box.rows(), box.layers())));
        form.count(
            NodeFields.ROWS,
            text("rows"),
            box.rows(),
            n -> with(step, new Pattern.Box(box.corners(), box.columns(), n, box.layers())));
        form.count(
            NodeFields.LAYERS,
            text("layers"),
            box.layers(),
            n -> with(step, new Pattern.Box(box.corners(), box.columns(), box.rows(), n)));
      }
      case Pattern.Places _ -> {}
    }
    form.drawing("pattern-drawing", new Sketch.Places(pattern), words(pattern));
    corners(form, step, pattern);
    return form.build();
  }

  private static Palletizing with(Palletizing was, Pattern pattern) {
    return new Palletizing(was.name(), pattern, was.feature(), was.remember());
  }

  private static String words(Pattern pattern) {
    return switch (pattern) {
      case Pattern.Line line -> text("placesOnALine", line.count());
      case Pattern.Square square -> text("rowsOfPlaces", square.rows(), square.columns());
      case Pattern.Box box -> text("layersOfRowsOfPlaces", box.layers(), box.rows(), box.columns());
      case Pattern.Places places -> text("severalPlaces", places.places().size());
    };
  }

  /** Corners that two kinds have in common go over. */
  private static Pattern pattern(Kept kept, Pattern was, String chosen) {
    List<String> corners = names(was);
    return switch (chosen) {
      case "line" ->
          kept.recall(
              Pattern.Line.class,
              new Pattern.Line(
                  at(corners, 0), at(corners, 1), (int) NodeFields.LINE_PLACES.initialValue()));
      case "square" ->
          kept.recall(
              Pattern.Square.class,
              new Pattern.Square(
                  some(corners, CORNERS),
                  (int) NodeFields.COLUMNS.initialValue(),
                  (int) NodeFields.ROWS.initialValue()));
      case "box" ->
          kept.recall(
              Pattern.Box.class,
              new Pattern.Box(
                  some(corners, 2 * CORNERS),
                  (int) NodeFields.COLUMNS.initialValue(),
                  (int) NodeFields.ROWS.initialValue(),
                  (int) NodeFields.LAYERS.initialValue()));
      default -> kept.recall(Pattern.Places.class, new Pattern.Places(corners));
    };
  }

  private static List<String> names(Pattern pattern) {
    return switch (pattern) {
      case Pattern.Line line -> List.of(line.first(), line.last());
      case Pattern.Square square -> square.corners();
      case Pattern.Box box -> box.corners();
      case Pattern.Places places -> places.places();
    };
  }

  private static String at(List<String> names, int index) {
    return index < names.size() ? names.get(index) : "";
  }

  private static List<String> some(List<String> names, int count) {
    List<String> all = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      all.add(at(names, i));
    }
    return all;
  }

  private static void corners(FormBuilder form, Palletizing step, Pattern pattern) {
    form.part(
        switch (pattern) {
          case Pattern.Line _ -> text("ends");
          case Pattern.Square _, Pattern.Box _ -> text("corners");
          case Pattern.Places _ -> text("places");
        });
    switch (pattern) {
      case Pattern.Line line -> {
        corner(
            form,
            "pattern.first",
            text("firstEnd"),
            line.first(),
            (_, name) -> with(step, new Pattern.Line(name, line.last(), line.count())));
        corner(
            form,
            "pattern.last",
            text("lastEnd"),
            line.last(),
            (_, name) -> with(step, new Pattern.Line(line.first(), name, line.count())));
      }
      case Pattern.Square square -> {
        List<String> corners = some(square.corners(), CORNERS);
        for (int i = 0; i < CORNERS; i++) {
          int at = i;
          corner(
              form,
              "pattern.corners." + i,
              text("cornerNumbered", i + 1),
              corners.get(i),
              (_, name) ->
                  with(
                      step,
                      new Pattern.Square(
                          replaced(corners, at, name), square.columns(), square.rows())));
        }
      }
      case Pattern.Box box -> {
        List<String> corners = some(box.corners(), 2 * CORNERS);
        for (int i = 0; i < 2 * CORNERS; i++) {
          int at = i;
          corner(
              form,
              "pattern.corners." + i,
              text(i < CORNERS ? "cornerAtTheBottom" : "cornerAtTheTop", i + 1),
              corners.get(i),
              (_, name) ->
                  with(
                      step,
                      new Pattern.Box(
                          replaced(corners, at, name), box.columns(), box.rows(), box.layers())));
        }
      }
      case Pattern.Places places -> places(form, step, places.places());
    }
  }

  private static void places(FormBuilder form, Palletizing step, List<String> places) {
    if (places.isEmpty()) {
      form.quiet("no-places", text("noPlaceYet"));
    }
    for (int i = 0; i < places.size(); i++) {
      int at = i;
      corner(
          form,
          "pattern.places." + i,
          text("place", i + 1),
          places.get(i),
          (_, name) -> with(step, new Pattern.Places(replaced(places, at, name))));
    }
    List<String> more = new ArrayList<>(places);
    more.add("");
    List<Item.Press> buttons = new ArrayList<>();
    buttons.add(
        form.edit(
            "add-place",
            text("addAPlace"),
            text("addAPlaceAtTheEnd"),
            tree -> tree.withStep(form.context().key(), with(step, new Pattern.Places(more)))));
    if (!places.isEmpty()) {
      List<String> fewer = places.subList(0, places.size() - 1);
      buttons.add(
          form.edit(
              "remove-place",
              text("removeTheLast"),
              text("takeTheLastPlaceOutOf"),
              tree -> tree.withStep(form.context().key(), with(step, new Pattern.Places(fewer)))));
    }
    form.add(new Item.Presses("places", "", buttons));
  }

  private static List<String> replaced(List<String> names, int index, String name) {
    List<String> all = new ArrayList<>(names);
    all.set(index, name);
    return all;
  }

  private static void corner(
      FormBuilder form,
      String name,
      String label,
      String waypoint,
      BiFunction<ProgramTree, String, Palletizing> step) {
    FormContext context = form.context();
    String prefix = context.node().step() instanceof Palletizing own ? own.name() : "";
    new Teachable(
            context,
            name,
            label,
            waypoint,
            (Identifiers.wellFormed(prefix) ? prefix : "Pallet") + "_corner_",
            (now, chosen) -> now.withStep(context.key(), step.apply(now, chosen)))
        .addTo(form);
  }
}
