package org.pendant.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

final class TextBundlesTest {
  private static final Pattern KEY = Pattern.compile("\"([-A-Za-z0-9_.]+)\"");

  @Test
  void everythingIsSaidInEveryLanguage() throws IOException {
    List<String> wrong = new ArrayList<>();
    for (Path english : TextBundles.english()) {
      Map<String, String> texts = TextBundles.read(english);
      for (Language language : List.of(Language.GERMAN, Language.CHINESE)) {
        Path file = TextBundles.in(language, english);
        Map<String, String> said = Files.exists(file) ? TextBundles.read(file) : Map.of();
        texts.forEach(
            (key, text) -> {
              if (said.getOrDefault(key, "").isBlank() != text.isBlank()) {
                wrong.add(file.getFileName() + " does not say " + key + ": " + text);
              }
            });
        said.keySet().stream()
            .filter(key -> !texts.containsKey(key))
            .forEach(key -> wrong.add(file.getFileName() + " says " + key + ", English does not"));
      }
    }
    assertEquals(List.of(), wrong);
  }

  @Test
  void noKeyIsThereTwice() throws IOException {
    List<String> wrong = new ArrayList<>();
    for (Path english : TextBundles.english()) {
      for (Language language : Language.values()) {
        Path file = language == Language.ENGLISH ? english : TextBundles.in(language, english);
        Set<String> keys = new HashSet<>();
        Files.readAllLines(file).stream()
            .filter(line -> line.contains(" = ") && !line.startsWith("#"))
            .map(line -> line.substring(0, line.indexOf(" = ")))
            .filter(key -> !keys.add(key))
            .forEach(key -> wrong.add(file.getFileName() + " says " + key + " twice"));
      }
    }
    assertEquals(List.of(), wrong);
  }

  @Test
  void valuesHaveTheirPlaceInEveryLanguage() throws IOException {
    List<String> wrong = new ArrayList<>();
    for (Path english : TextBundles.english()) {
      Map<String, String> texts = TextBundles.read(english);
      for (Language language : List.of(Language.GERMAN, Language.CHINESE)) {
        TextBundles.read(TextBundles.in(language, english))
            .forEach(
                (key, said) -> {
                  String text = texts.getOrDefault(key, said);
                  if (!TextBundles.places(said).equals(TextBundles.places(text))) {
                    wrong.add(language.code() + " " + key + ": " + text + " / " + said);
                  }
                });
      }
    }
    assertEquals(List.of(), wrong);
  }

  @Test
  void everyTextIsUsedByItsPackage() throws IOException {
    List<String> unused = new ArrayList<>();
    for (Path english : TextBundles.english()) {
      TreeMap<String, String> texts = TextBundles.read(english);
      for (Path source : TextBundles.sources(english)) {
        Matcher key = KEY.matcher(Files.readString(source));
        while (key.find()) {
          texts.remove(key.group(1));
        }
      }
      texts.keySet().forEach(key -> unused.add(english.getFileName() + ": " + key));
    }
    assertEquals(List.of(), unused);
  }

  @Test
  void whatIsSaidInEnglishIsTranslatedByTheBundlesOfAllWhoSayIt() throws IOException {
    List<String> below = new ArrayList<>();
    for (Path english : TextBundles.english()) {
      if (TextBundles.isTranslatedWhereShown(english)) {
        below.add(TextBundles.name(english));
      }
    }
    assertEquals(below.stream().sorted().toList(), TextBundles.translatedWhereShown());
  }

  /** Two texts that fit the same message, in different words of another language, are a mistake. */
  @Test
  void messagesAreRecognisedByTheTextsThatTheyWereMadeOf() throws IOException {
    List<String> wrong = new ArrayList<>();
    for (Language language : List.of(Language.GERMAN, Language.CHINESE)) {
      MessageTranslator elsewhere = new MessageTranslator(language);
      MessageTranslator inEditors = new MessageTranslator(language, TextBundles.OF_EDITORS);
      for (Path english : TextBundles.english()) {
        if (!TextBundles.isTranslatedWhereShown(english)) {
          continue;
        }
        boolean ofEditors = TextBundles.name(english).startsWith(TextBundles.OF_EDITORS);
        MessageTranslator translator = ofEditors ? inEditors : elsewhere;
        Map<String, String> said = TextBundles.read(TextBundles.in(language, english));
        TextBundles.read(english)
            .forEach(
                (key, text) -> {
                  String shown = translator.shown(TextBundles.withValues(text));
                  String expected = TextBundles.withValues(said.getOrDefault(key, text));
                  if (!shown.equals(expected)) {
                    wrong.add(
                        TextBundles.name(english) + " " + key + ": " + expected + " / " + shown);
                  }
                });
      }
    }
    assertEquals(String.join("\n", List.of()), String.join("\n", wrong));
  }

  @Test
  void linksOfAnArmThatHitSomethingAreSaidInTheOtherLanguageToo() throws IOException {
    Translations german =
        Translations.of(
            Language.GERMAN, getClass().getClassLoader(), TextBundles.translatedWhereShown());
    assertEquals("Unterarm hat „post“ berührt", german.of("the forearm has hit \"post\""));
    assertEquals(
        "Handgelenk 1 hat Oberarm berührt", german.of("the wrist 1 has hit the upper arm"));
  }
}
