package org.pendant.project.program.text;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.pendant.project.program.Section;
import org.pendant.project.program.Step;

/**
 * Text forms: which records stand for which words; the names of records and their components are
 * the format.
 */
final class Forms {
  /** Components that are lines of text below the node, not fields. */
  private static final Set<String> BLOCKS = Set.of("lines", "data", "stub", "values");

  /** Words that differ from the name of the record. */
  private static final Map<String, String> SHORT =
      Map.of("main-program", "main", "thread-section", "thread", "set-action", "set");

  /** Where a word of a name in the language ends and the next one begins. */
  private static final Pattern BETWEEN_WORDS =
      Pattern.compile("(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])");

  // Programs are written at each key that is pressed: what follows from a class is kept.
  private static final ClassValue<String> WORDS =
      new ClassValue<>() {
        @Override
        protected String computeValue(Class<?> record) {
          String kebab = kebab(record.getSimpleName());
          return SHORT.getOrDefault(kebab, kebab);
        }
      };

  private static final ClassValue<List<Field>> FIELDS =
      new ClassValue<>() {
        @Override
        protected List<Field> computeValue(Class<?> record) {
          return Arrays.stream(record.getRecordComponents())
              .map(each -> new Field(each, kebab(each.getName()), block(each)))
              .toList();
        }
      };

  private static final ClassValue<List<Class<? extends Record>>> VARIANTS =
      new ClassValue<>() {
        @Override
        protected List<Class<? extends Record>> computeValue(Class<?> family) {
          return leaves(family).toList();
        }
      };

  private static final Map<String, Class<? extends Record>> STEPS = steps();

  /**
   * A component of a record.
   *
   * @param key before its value
   * @param block whether it stands in lines below the node
   */
  record Field(RecordComponent component, String key, boolean block) {}

  private Forms() {}

  private static Map<String, Class<? extends Record>> steps() {
    Map<String, Class<? extends Record>> all = new LinkedHashMap<>();
    leaves(Step.class).forEach(each -> all.put(word(each), each));
    return all;
  }

  /** The records of a sealed family, those of families within it included. */
  static Stream<Class<? extends Record>> leaves(Class<?> family) {
    return Arrays.stream(family.getPermittedSubclasses())
        .flatMap(each -> each.isSealed() ? leaves(each) : Stream.of(each.asSubclass(Record.class)));
  }

  /** The same as a list. */
  static List<Class<? extends Record>> variants(Class<?> family) {
    return VARIANTS.get(family);
  }

  /** All words that can begin the line of a node. */
  static List<String> words() {
    return List.copyOf(STEPS.keySet());
  }

  /** The record whose line begins with a word; null if there is none. */
  static Class<? extends Record> step(String word) {
    return STEPS.get(word);
  }

  /** The word that begins the line of a step, or names a variant. */
  static String word(Class<?> record) {
    return WORDS.get(record);
  }

  /** The components of a record, in order. */
  static List<Field> fields(Class<?> record) {
    return FIELDS.get(record);
  }

  /** A name of the language as a word: {@code blendRadiusM} becomes {@code blend-radius-m}. */
  static String kebab(String name) {
    return BETWEEN_WORDS.matcher(name).replaceAll("-").toLowerCase(Locale.ROOT);
  }

  /** The word of a constant. */
  static String word(Enum<?> constant) {
    return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Whether a component stands in lines below the node. */
  static boolean block(RecordComponent component) {
    return component.getType() == List.class && BLOCKS.contains(component.getName());
  }

  /** The mark with which the lines of a block begin. */
  static char mark(RecordComponent component) {
    return switch (component.getName()) {
      case "stub" -> '>';
      case "values" -> '-';
      default -> '|';
    };
  }

  /** Whether the block has rows of fields, as initial values have. */
  static boolean rows(RecordComponent component) {
    return component.getDeclaringRecord() == Section.InitialValues.class;
  }
}
