package org.pendant.recording.compare;

import static org.pendant.recording.compare.CompareTexts.text;

import java.io.IOException;
import java.io.Reader;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.models.arm.Joints;
import org.pendant.recording.compare.ColumnRole.JointArray;
import org.pendant.recording.compare.TableLines.Cell;

/**
 * Sample table: reads samples from a table of text: what clients of RTDE write, Pendant's own
 * tables, and what becomes of {@code /joint_states} in a ROS bag (docs/fidelity.md has the forms).
 */
public final class SampleTable {
  /** Numbers that one file may hold; ten minutes of everything that RTDE has, at 500 Hz. */
  static final int MAX_NUMBERS = 50_000_000;

  private static final double NANO = 1e-9;
  private static final String CLOSING = ")]";

  /** Columns of {@code ros2 topic echo --csv} before the arrays: seconds, nanoseconds, frame. */
  private static final int ROS2_HEADER_CELLS = 3;

  private final TableLines lines;
  private final OptionalDouble periodS;
  private final List<String> notes = new ArrayList<>();

  private List<ColumnRole> roles = List.of();
  private final Map<String, Integer> placeOf = new HashMap<>();
  private List<StateQuantity> quantities = List.of();
  private double[] row = new double[0];
  private int skipped;

  /**
   * What was read.
   *
   * @param notes what people should know of it
   */
  public record Read(Samples samples, List<String> notes) {
    /** Copies the list. */
    public Read {
      notes = List.copyOf(notes);
    }
  }

  private SampleTable(String file, Reader in, OptionalDouble periodS) {
    lines = new TableLines(file, in);
    this.periodS = periodS;
  }

  /**
   * Reads a table.
   *
   * @param file its name, for messages
   * @param periodS time between two rows, s, which counts where the table has no column of times
   * @throws MalformedTable when it is none; with file, line and column
   */
  public static Read read(String file, Reader in, OptionalDouble periodS)
      throws IOException, MalformedTable {
    return new SampleTable(file, in, periodS).read();
  }

  private Read read() throws IOException, MalformedTable {
    List<Cell> first = lines.next().orElseThrow(() -> lines.wrong(1, text("fileEmpty")));
    boolean headless = number(first.getFirst().text()).isPresent();
    roles =
        headless
            ? ros2Roles(first)
            : first.stream().map(cell -> ColumnRole.of(cell.text())).toList();
    Optional<List<Cell>> cells = headless ? Optional.of(first) : lines.next();
    if (cells.isEmpty()) {
      throw lines.wrong(1, text("noRows"));
    }
    chooseQuantities(cells.get());
    Optional<ColumnRole.Time> clock = clock();
    Samples.Builder builder = new Samples.Builder(quantities);
    double originS = Double.NaN;
    for (long index = 0; cells.isPresent(); index++) {
      if (cells.get().size() != roles.size()) {
        if (lines.cut()) {
          notes.add(text("lastLineCut"));
          break;
        }
        throw lines.wrong(1, text("cellCount", cells.get().size(), roles.size()));
      }
      double timeS = timeS(cells.get(), clock, index);
      if (Double.isNaN(originS)) {
        originS = timeS;
      }
      add(cells.get(), timeS - originS, builder);
      cells = lines.next();
    }
    if (skipped > 0) {
      notes.add(text("rowsLeftOut", skipped));
    }
    if (builder.rows() < 2) {
      throw lines.wrong(1, text("tooFewRows", builder.rows()));
    }
    return new Read(builder.build(), notes);
  }

  /** {@code ros2 topic echo --csv} writes no headings. */
  private List<ColumnRole> ros2Roles(List<Cell> first) throws MalformedTable {
    int arrays = first.size() - ROS2_HEADER_CELLS;
    int joints = arrays / JointArray.values().length;
    if (joints < Joints.COUNT || arrays % JointArray.values().length != 0) {
      throw lines.wrong(1, text("noHeadings", first.size()));
    }
    List<ColumnRole> all = new ArrayList<>();
    all.add(new ColumnRole.StampSeconds());
    all.add(new ColumnRole.StampNanoseconds());
    all.add(new ColumnRole.Other());
    for (JointArray array : JointArray.values()) {
      for (int i = 0; i < joints; i++) {
        all.add(new ColumnRole.Element(array, i));
      }
    }
    return all;
  }

  /** Those of which all numbers are there, and which are worth comparing. */
  private void chooseQuantities(List<Cell> firstRow) throws MalformedTable {
    Map<String, Set<Integer>> found = new LinkedHashMap<>();
    for (int i = 0; i < roles.size(); i++) {
      Optional<StateQuantity> whole =
          switch (roles.get(i)) {
            case ColumnRole.Measure number -> {
              found
                  .computeIfAbsent(number.quantity().name(), _ -> new LinkedHashSet<>())
                  .add(number.component());
              yield Optional.empty();
            }
            case ColumnRole.Element element -> element.array().quantity();
            case ColumnRole.Whole list ->
                i < firstRow.size() && elements(firstRow.get(i).text()).isEmpty()
                    ? Optional.empty()
                    : list.array().quantity();
            case ColumnRole.Time _,
                ColumnRole.StampSeconds _,
                ColumnRole.StampNanoseconds _,
                ColumnRole.Other _ ->
                Optional.empty();
          };
      whole.ifPresent(
          quantity ->
              found
                  .computeIfAbsent(quantity.name(), _ -> new LinkedHashSet<>())
                  .addAll(List.of(0, 1, 2, 3, 4, 5)));
    }
    List<StateQuantity> chosen = new ArrayList<>();
    int size = 0;
    for (StateQuantity each : SampledQuantity.all()) {
      int components = found.getOrDefault(each.name(), Set.of()).size();
      if (components == each.size()) {
        chosen.add(each);
        placeOf.put(each.name(), size);
        size += each.size();
      } else if (components > 0) {
        notes.add(text("quantityLeftOut", SampledQuantity.name(each), components, each.size()));
      }
    }
    quantities = chosen;
    row = new double[size];
    if (!placeOf.containsKey("actual_q") && !placeOf.containsKey("target_q")) {
      throw lines.wrong(1, text("noPositions"));
    }
    boolean arrays =
        roles.stream()
            .anyMatch(
                role -> role instanceof ColumnRole.Element || role instanceof ColumnRole.Whole);
    if (arrays && !hasNames()) {
      throw lines.wrong(1, text("noJointNames"));
    }
  }

  private boolean hasNames() {
    return roles.stream().anyMatch(role -> isElementOfNames(role) || isListOfNames(role));
  }

  private static boolean isElementOfNames(ColumnRole role) {
    return role instanceof ColumnRole.Element(JointArray array, int _) && array == JointArray.NAME;
  }

  private static boolean isListOfNames(ColumnRole role) {
    return role instanceof ColumnRole.Whole(JointArray array) && array == JointArray.NAME;
  }

  /** The best column of times; empty for the stamp of ROS, or for a given period. */
  private Optional<ColumnRole.Time> clock() throws MalformedTable {
    boolean stamped = roles.stream().anyMatch(ColumnRole.StampSeconds.class::isInstance);
    if (stamped) {
      return Optional.empty();
    }
    Optional<ColumnRole.Time> best =
        roles.stream()
            .filter(ColumnRole.Time.class::isInstance)
            .map(ColumnRole.Time.class::cast)
            .max((a, b) -> Integer.compare(a.rank(), b.rank()));
    if (best.isEmpty() && periodS.isEmpty()) {
      throw lines.wrong(1, text("noTimes"));
    }
    return best;
  }

  private double timeS(List<Cell> cells, Optional<ColumnRole.Time> clock, long index)
      throws MalformedTable {
    double seconds = 0;
    boolean told = false;
    for (int i = 0; i < roles.size(); i++) {
      switch (roles.get(i)) {
        case ColumnRole.Time time -> {
          if (!told && clock.isPresent() && clock.get().equals(time)) {
            seconds = time.unitS() * needed(cells.get(i));
            told = true;
          }
        }
        case ColumnRole.StampSeconds _ -> {
          seconds += needed(cells.get(i));
          told = true;
        }
        case ColumnRole.StampNanoseconds _ -> seconds += NANO * needed(cells.get(i));
        case ColumnRole.Measure _, ColumnRole.Element _, ColumnRole.Whole _, ColumnRole.Other _ -> {
          // no time
        }
      }
    }
    return told ? seconds : index * periodS.orElse(0);
  }

  private void add(List<Cell> cells, double timeS, Samples.Builder builder) throws MalformedTable {
    if (builder.rows() > 0 && timeS < builder.lastS()) {
      throw lines.wrong(1, text("timeGoesBack", timeS, builder.lastS()));
    }
    Arrays.fill(row, Double.NaN);
    int[] joints = joints(cells);
    for (int i = 0; i < roles.size(); i++) {
      Cell cell = cells.get(i);
      switch (roles.get(i)) {
        case ColumnRole.Measure(StateQuantity quantity, int component) ->
            fill(quantity, component, cell);
        case ColumnRole.Element(JointArray array, int index) -> {
          int joint = index < joints.length ? joints[index] : -1;
          if (joint >= 0 && array.quantity().isPresent()) {
            fill(array.quantity().get(), joint, cell);
          }
        }
        case ColumnRole.Whole(JointArray array) -> fill(array, joints, cell);
        case ColumnRole.Time _,
            ColumnRole.StampSeconds _,
            ColumnRole.StampNanoseconds _,
            ColumnRole.Other _ -> {
          // nothing to compare
        }
      }
    }
    boolean repeated = builder.rows() > 0 && timeS == builder.lastS();
    if (repeated || Arrays.stream(row).anyMatch(Double::isNaN)) {
      skipped++;
      return;
    }
    if ((long) (builder.rows() + 1) * row.length > MAX_NUMBERS) {
      throw lines.wrong(1, text("tableTooLarge", MAX_NUMBERS));
    }
    builder.add(timeS, row);
  }

  private void fill(JointArray array, int[] joints, Cell cell) throws MalformedTable {
    if (array.quantity().isEmpty()) {
      return;
    }
    List<String> elements = elements(cell.text());
    for (int i = 0; i < Math.min(elements.size(), joints.length); i++) {
      if (joints[i] >= 0) {
        fill(array.quantity().get(), joints[i], new Cell(elements.get(i), cell.column()));
      }
    }
  }

  /** Of two columns with the same number the first counts. */
  private void fill(StateQuantity quantity, int component, Cell cell) throws MalformedTable {
    Integer place = placeOf.get(quantity.name());
    if (place != null && Double.isNaN(row[place + component])) {
      row[place + component] = needed(cell);
    }
  }

  /** The joint of each element of the row's arrays. */
  private int[] joints(List<Cell> cells) {
    List<String> names = new ArrayList<>();
    for (int i = 0; i < roles.size(); i++) {
      if (isElementOfNames(roles.get(i))) {
        names.add(cells.get(i).text());
      } else if (isListOfNames(roles.get(i))) {
        names.addAll(elements(cells.get(i).text()));
      }
    }
    return names.stream().mapToInt(ColumnRole::jointOf).toArray();
  }

  /** The elements of a list as Python writes it: {@code ['a', 'b']}, {@code (1.0, 2.0)}. */
  private static List<String> elements(String list) {
    int from = Math.max(list.lastIndexOf('['), list.lastIndexOf('(')) + 1;
    int end = from;
    while (end < list.length() && CLOSING.indexOf(list.charAt(end)) < 0) {
      end++;
    }
    String inner = list.substring(from, end);
    return Arrays.stream(inner.split("[,\\s]+"))
        .map(each -> each.replace("'", "").replace("\"", ""))
        .filter(each -> !each.isEmpty())
        .toList();
  }

  private double needed(Cell cell) throws MalformedTable {
    OptionalDouble number = number(cell.text());
    if (number.isEmpty() || !Double.isFinite(number.getAsDouble())) {
      throw lines.wrong(cell.column(), text("expectedNumber", shown(cell.text())));
    }
    return number.getAsDouble();
  }

  private static String shown(String text) {
    int most = 40;
    return text.length() <= most ? text : text.substring(0, most) + "...";
  }

  private static OptionalDouble number(String text) {
    if (text.equalsIgnoreCase("true")) {
      return OptionalDouble.of(1);
    }
    if (text.equalsIgnoreCase("false")) {
      return OptionalDouble.of(0);
    }
    try {
      return text.isEmpty() ? OptionalDouble.empty() : OptionalDouble.of(Double.parseDouble(text));
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }
}
