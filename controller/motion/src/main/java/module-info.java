/**
 * How an arm gets from here to there: trajectories, blends, time scaling, servoing, force mode,
 * toolpaths.
 */
module org.pendant.motion {
  requires transitive org.pendant.models;
  requires org.pendant.text;

  exports org.pendant.motion;
  exports org.pendant.motion.force;
  exports org.pendant.motion.offset;
  exports org.pendant.motion.servo;
  exports org.pendant.motion.toolpath;
  exports org.pendant.motion.toolpath.nc;
}
