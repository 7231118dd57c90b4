package org.pendant;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.belongToAnyOf;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noFields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noMethods;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaMethod;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.awt.event.ActionListener;
import java.lang.reflect.ParameterizedType;
import java.nio.channels.FileChannel;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import javax.swing.Timer;
import org.pendant.controller.Controller;
import org.pendant.controller.Drive;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.CommandHandler;
import org.pendant.editors.wire.ProtocolLog;
import org.pendant.script.function.Host;

/** The shape that docs/architecture.md describes, held by the build. */
@AnalyzeClasses(packages = "org.pendant", importOptions = ImportOption.DoNotIncludeTests.class)
final class ArchitectureTest {

  /** ANTLR's lexers have two static name tables that are not final. */
  private static final String GENERATED = "org\\.pendant\\.language\\.parse\\.\\w+Lexer";

  /** Packages of a module that use one another in a row. */
  private static final int MAX_DEPTH = 8;

  /** Parts that builtins and commands reach by the control box. */
  private static final int MAX_BOX_PARTS = 15;

  @ArchTest
  static final ArchRule modulesKnowOnlyTheModulesBelowThem =
      layeredArchitecture()
          .consideringOnlyDependenciesInAnyPackage("org.pendant..")
          .withOptionalLayers(true)
          .layer("text")
          .definedBy("org.pendant.text..")
          .layer("language")
          .definedBy("org.pendant.language..")
          .layer("models")
          .definedBy("org.pendant.models..")
          .layer("script")
          .definedBy("org.pendant.script..")
          .layer("motion")
          .definedBy("org.pendant.motion..")
          .layer("cell")
          .definedBy("org.pendant.cell..")
          .layer("core")
          .definedBy("org.pendant.controller..")
          .layer("recording")
          .definedBy("org.pendant.recording..")
          .layer("project")
          .definedBy("org.pendant.project..")
          .layer("testing")
          .definedBy("org.pendant.testing..")
          .layer("junit")
          .definedBy("org.pendant.junit..")
          .layer("sweep")
          .definedBy("org.pendant.sweep..")
          .layer("protocols")
          .definedBy("org.pendant.protocols..")
          .layer("editors")
          .definedBy("org.pendant.editors..")
          .layer("kit")
          .definedBy("org.pendant.kit..")
          .layer("command")
          .definedBy("org.pendant.command..")
          .layer("spark")
          .definedBy("org.pendant.spark..")
          .layer("desktop")
          .definedBy("org.pendant.desktop..")
          .whereLayer("desktop")
          .mayNotBeAccessedByAnyLayer()
          .whereLayer("spark")
          .mayNotBeAccessedByAnyLayer()
          .whereLayer("kit")
          .mayOnlyBeAccessedByLayers("desktop")
          .whereLayer("command")
          .mayOnlyBeAccessedByLayers("desktop")
          .whereLayer("editors")
          .mayOnlyBeAccessedByLayers("command", "desktop")
          .whereLayer("protocols")
          .mayOnlyBeAccessedByLayers("command", "desktop")
          .whereLayer("recording")
          .mayOnlyBeAccessedByLayers("junit", "sweep", "editors", "command", "desktop")
          .whereLayer("sweep")
          .mayOnlyBeAccessedByLayers("command", "spark", "desktop")
          .whereLayer("junit")
          .mayNotBeAccessedByAnyLayer()
          .whereLayer("testing")
          .mayOnlyBeAccessedByLayers("editors", "command", "desktop")
          .whereLayer("project")
          .mayOnlyBeAccessedByLayers(
              "testing", "junit", "sweep", "protocols", "editors", "command", "desktop")
          .whereLayer("core")
          .mayOnlyBeAccessedByLayers(
              "recording",
              "project",
              "testing",
              "junit",
              "sweep",
              "protocols",
              "editors",
              "command",
              "kit",
              "desktop")
          .whereLayer("cell")
          .mayOnlyBeAccessedByLayers(
              "core",
              "recording",
              "project",
              "testing",
              "junit",
              "sweep",
              "protocols",
              "editors",
              "command",
              "desktop")
          .whereLayer("script")
          .mayOnlyBeAccessedByLayers(
              "core",
              "recording",
              "project",
              "testing",
              "junit",
              "sweep",
              "protocols",
              "editors",
              "command",
              "desktop")
          .whereLayer("motion")
          .mayOnlyBeAccessedByLayers(
              "core",
              "recording",
              "project",
              "testing",
              "junit",
              "sweep",
              "protocols",
              "editors",
              "command",
              "desktop")
          .whereLayer("language")
          .mayOnlyBeAccessedByLayers(
              "script",
              "core",
              "recording",
              "project",
              "testing",
              "junit",
              "sweep",
              "protocols",
              "editors",
              "command",
              "desktop")
          .whereLayer("models")
          .mayOnlyBeAccessedByLayers(
              "script",
              "motion",
              "cell",
              "core",
              "recording",
              "project",
              "testing",
              "junit",
              "sweep",
              "protocols",
              "editors",
              "command",
              "desktop")
          .ensureAllClassesAreContainedInArchitecture();

  /** What docs/glossary.md has better words for. */
  @ArchTest
  static final ArchRule namesAreThoseOfTheField =
      noClasses()
          .should()
          .haveNameMatching(".*\\.\\w*(Desk|Doors?|Witness|Foresight|Succession|Headroom)");

  @ArchTest
  static final ArchRule limitsAreMaximaAndMinima =
      noFields()
          .that()
          .areStatic()
          .should()
          .haveNameMatching("(MOST|LEAST|FARTHEST|LONGEST|LARGEST|HIGHEST|SMALLEST|SHORTEST)_.*");

  /** It is a jar of its own, for those who have Spark. */
  @ArchTest
  static final ArchRule onlyTheModuleForSparkKnowsSpark =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.pendant.spark..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("org.apache.spark..", "scala..");

  @ArchTest
  static final ArchRule packagesFormNoCycle =
      slices().assignedFrom(new OneSlicePerPackage()).should().beFreeOfCycles();

  /** A module whose packages stack higher has more than one idea. */
  @ArchTest
  static void packagesOfAModuleStackAtMostEightDeep(JavaClasses all) {
    PackageDepth depth = new PackageDepth(all);
    List<String> tooDeep =
        depth.deepestChains().values().stream()
            .filter(chain -> chain.size() > MAX_DEPTH)
            .map(chain -> String.join(" > ", chain))
            .toList();
    assertEquals(List.of(), tooDeep);
  }

  @ArchTest
  static final ArchRule onlyTheCommandLineEndsTheProcess =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.pendant.command..")
          .should()
          .callMethod(System.class, "exit", int.class)
          .orShould()
          .callMethod(Runtime.class, "exit", int.class)
          .orShould()
          .callMethod(Runtime.class, "halt", int.class);

  @ArchTest
  static final ArchRule onlyTheCommandLineUsesTheProcessStreams =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.pendant.command..")
          .should()
          .accessField(System.class, "out")
          .orShould()
          .accessField(System.class, "err")
          .orShould()
          .accessField(System.class, "in")
          .orShould()
          .callMethod(Throwable.class, "printStackTrace");

  @ArchTest
  static final ArchRule theKitKnowsNoRobot =
      noClasses()
          .that()
          .resideInAPackage("org.pendant.kit..")
          .should()
          .dependOnClassesThat(
              resideInAPackage("org.pendant..")
                  .and(
                      not(
                          resideInAnyPackage(
                              "org.pendant.kit..",
                              "org.pendant.controller.disk",
                              "org.pendant.text"))));

  @ArchTest
  static final ArchRule onlyTheCommandLineHasAMain =
      noMethods()
          .that()
          .areDeclaredInClassesThat()
          .resideOutsideOfPackage("org.pendant.command..")
          .should()
          .haveName("main")
          .andShould()
          .haveRawParameterTypes(String[].class);

  @ArchTest
  static final ArchRule onlyKitAndDesktopKnowAScreen =
      noClasses()
          .that()
          .resideOutsideOfPackages("org.pendant.kit..", "org.pendant.desktop..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "java.awt..",
              "java.applet..",
              "java.beans..",
              "javax.accessibility..",
              "javax.imageio..",
              "javax.print..",
              "javax.sound..",
              "javax.swing..",
              "com.formdev..",
              "org.joml..",
              "org.lwjgl..");

  @ArchTest
  static final ArchRule timersContinueAfterAFault =
      noClasses()
          .that()
          .resideOutsideOfPackage("org.pendant.kit.fault..")
          .should()
          .callConstructor(Timer.class, int.class, ActionListener.class)
          .because("Swing never fires a timer again whose listener has thrown");

  @ArchTest
  static final ArchRule onlyProtocolsCommandAndDesktopKnowSockets =
      noClasses()
          .that()
          .resideInAnyPackage(
              "org.pendant.language..",
              "org.pendant.models..",
              "org.pendant.script..",
              "org.pendant.motion..",
              "org.pendant.cell..",
              "org.pendant.controller..",
              "org.pendant.recording..",
              "org.pendant.project..",
              "org.pendant.testing..",
              "org.pendant.junit..",
              "org.pendant.sweep..",
              "org.pendant.kit..")
          .should()
          .dependOnClassesThat(
              resideInAnyPackage("java.net..", "java.nio.channels..")
                  .and(not(belongToAnyOf(FileChannel.class))));

  /** But what takes the lines of a library that logs there. */
  @ArchTest
  static final ArchRule nothingUsesJavaUtilLogging =
      noClasses()
          .that()
          .doNotBelongToAnyOf(ProtocolLog.class)
          .should()
          .dependOnClassesThat()
          .resideInAPackage("java.util.logging..");

  @ArchTest
  static final ArchRule staticFieldsNeverChange =
      fields()
          .that()
          .areStatic()
          .and()
          .areDeclaredInClassesThat()
          .haveNameNotMatching(GENERATED)
          .should()
          .beFinal()
          .because("several controllers run in one process");

  @ArchTest
  static final ArchRule namesSayWhatAClassIs =
      noClasses().should().haveNameMatching(".*(Utils?|Helper|Manager|Impl|Singleton)");

  /** Classes inside others are told apart by these. */
  @ArchTest
  static void oneSimpleNameIsOneClass(JavaClasses all) {
    Map<String, Set<String>> classesByName = new TreeMap<>();
    for (JavaClass each : all) {
      // annotations are read where they stand, and are named for that place
      if (each.isTopLevelClass()
          && !each.isAnnotation()
          && !each.getSimpleName().equals("package-info")) {
        classesByName
            .computeIfAbsent(each.getSimpleName(), name -> new TreeSet<>())
            .add(each.getName());
      }
    }
    classesByName.values().removeIf(classes -> classes.size() == 1);
    assertEquals(Map.of(), classesByName);
  }

  @ArchTest
  static final ArchRule everyClassHasAPackageOfOneModule =
      classes().should().resideInAPackage("org.pendant.*..");

  private static final class OneSlicePerPackage implements SliceAssignment {
    @Override
    public SliceIdentifier getIdentifierOf(JavaClass javaClass) {
      return SliceIdentifier.of(javaClass.getPackageName());
    }

    @Override
    public String getDescription() {
      return "packages";
    }
  }

  @ArchTest
  static final ArchRule clientsHaveTheRobotAndDoNotDriveIt =
      noClasses()
          .that()
          .resideInAPackage("org.pendant.protocols..")
          .should()
          .dependOnClassesThat()
          .belongToAnyOf(Controller.class, Drive.class);

  @ArchTest
  static final ArchRule viewsHaveTheRobotAndOnlyTheSessionDrivesIt =
      noClasses()
          .that()
          .resideInAPackage("org.pendant.desktop..")
          .and()
          .resideOutsideOfPackage("org.pendant.desktop.session..")
          .should()
          .dependOnClassesThat()
          .belongToAnyOf(Controller.class, Drive.class);

  @ArchTest
  static final ArchRule commandAndDesktopKeepTheRobotOrTheDriveAndNotTheController =
      noFields()
          .that()
          .areDeclaredInClassesThat()
          .resideInAnyPackage("org.pendant.command..", "org.pendant.desktop..")
          .should()
          .haveRawType(Controller.class);

  @ArchTest
  static void theControlBoxHasAFewPartsAndIsNoBagOfGetters(JavaClasses all) {
    List<String> parts =
        all.get(ControlBox.class).getMethods().stream()
            .filter(each -> each.getModifiers().contains(JavaModifier.PUBLIC))
            .filter(each -> !each.getRawReturnType().isEquivalentTo(void.class))
            .map(JavaMethod::getName)
            .filter(name -> all.get(Host.class).getMethods().stream().noneMatch(called(name)))
            .toList();
    assertTrue(parts.size() <= MAX_BOX_PARTS, parts.size() + " parts: " + parts);
  }

  private static Predicate<JavaMethod> called(String name) {
    return method -> method.getName().equals(name);
  }

  @ArchTest
  static void everyCommandIsARecordOfASealedFamilyThatOneClassCarriesOut(JavaClasses all) {
    List<Class<?>> families =
        all.stream()
            .filter(each -> each.isAssignableTo(CommandHandler.class) && !each.isInterface())
            .flatMap(each -> Arrays.stream(each.reflect().getGenericInterfaces()))
            .filter(ParameterizedType.class::isInstance)
            .map(ParameterizedType.class::cast)
            .filter(each -> each.getRawType() == CommandHandler.class)
            .<Class<?>>map(each -> (Class<?>) each.getActualTypeArguments()[0])
            .toList();
    assertEquals(Set.copyOf(families).size(), families.size(), "two classes for one family");
    all.stream()
        .filter(each -> each.isAssignableTo(Command.class) && !each.isInterface())
        .forEach(
            each -> {
              Class<?> command = each.reflect();
              assertTrue(command.isRecord(), command + " is no record");
              assertTrue(
                  Arrays.stream(command.getInterfaces())
                      .anyMatch(family -> family.isSealed() && families.contains(family)),
                  "nobody carries out the family of " + command);
            });
  }
}
