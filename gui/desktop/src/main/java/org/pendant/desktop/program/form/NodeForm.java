package org.pendant.desktop.program.form;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Node form: what is shown of one node: values and what can be done with them.
 *
 * @param kind of the node, a word for names of controls such as {@code waypoint}
 * @param title of the kind, for people
 * @param about what such a node does, in one line
 */
record NodeForm(String kind, String title, String about, List<Part> parts) {
  NodeForm {
    parts = List.copyOf(parts);
  }

  /** Items under a heading. */
  record Part(String title, List<Item> items) {
    Part {
      items = List.copyOf(items);
    }
  }

  /** All items, also those inside of others, in the order of the screen. */
  Stream<Item> items() {
    return parts.stream().flatMap(part -> part.items().stream()).flatMap(NodeForm::flat);
  }

  private static Stream<Item> flat(Item item) {
    return switch (item) {
      case Item.Grid grid -> Stream.concat(Stream.of(item), grid.numbers().stream());
      case Item.Line line ->
          Stream.concat(Stream.of(item), line.items().stream().flatMap(NodeForm::flat));
      case Item.Quantity _,
          Item.Text _,
          Item.Expression _,
          Item.Prose _,
          Item.Code _,
          Item.Choice _,
          Item.Check _,
          Item.Presses _,
          Item.Note _,
          Item.Drawing _ ->
          Stream.of(item);
    };
  }

  /** The item of a name. */
  Optional<Item> item(String name) {
    return items().filter(each -> each.name().equals(name)).findFirst();
  }

  /**
   * The item where a problem with a component of the step is shown: the only field of what was
   * chosen for it, otherwise where it is chosen.
   */
  Optional<Item> itemFor(String component) {
    Predicate<String> inner = name -> name.matches(Pattern.quote(component) + "\\.\\D.*");
    List<Item> fields =
        items()
            .filter(NodeForm::hasValue)
            .filter(each -> inner.test(each.name()))
            .limit(2)
            .toList();
    if (fields.size() == 1) {
      return Optional.of(fields.getFirst());
    }
    return Stream.<Predicate<String>>of(
            name -> name.equals(component), name -> name.endsWith("." + component), inner)
        .flatMap(
            test ->
                items().filter(NodeForm::hasValue).filter(each -> test.test(each.name())).limit(1))
        .findFirst();
  }

  /** The first item that the user can change. */
  Optional<Item> firstField() {
    return items().filter(NodeForm::hasValue).findFirst();
  }

  private static boolean hasValue(Item item) {
    return switch (item) {
      case Item.Quantity _,
          Item.Text _,
          Item.Expression _,
          Item.Prose _,
          Item.Code _,
          Item.Choice _,
          Item.Check _ ->
          true;
      case Item.Presses _, Item.Note _, Item.Drawing _, Item.Grid _, Item.Line _ -> false;
    };
  }

  /** What has to be the same for two forms to be shown by the same controls. */
  List<String> shape() {
    Stream<String> titles = parts.stream().map(part -> part.title() + part.items().size());
    return Stream.concat(Stream.concat(Stream.of(kind), titles), items().map(NodeForm::shapeOf))
        .toList();
  }

  /** What has to be the same for two items to be shown by the same control. */
  static String shapeOf(Item item) {
    String own =
        switch (item) {
          case Item.Choice choice -> choice.side() ? choice.options().toString() : "";
          case Item.Presses presses ->
              presses.buttons().stream().map(each -> each.name() + each.text()).toList().toString();
          case Item.Code code -> code.edit().isPresent() + "";
          case Item.Grid grid ->
              grid.numbers().stream()
                  .map(each -> each.label() + each.measure())
                  .toList()
                  .toString();
          case Item.Quantity _,
              Item.Text _,
              Item.Expression _,
              Item.Prose _,
              Item.Check _,
              Item.Note _,
              Item.Drawing _,
              Item.Line _ ->
              "";
        };
    return item.getClass().getSimpleName() + " " + item.name() + " " + item.label() + " " + own;
  }
}
