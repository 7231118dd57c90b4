/**
 * Toolpaths and the remote TCP (manual 20): motions that are queued and run as one path with
 * look-ahead, by a tool on the arm or, with the part on the arm, past a tool that stands still.
 * Open {@link org.pendant.motion.toolpath.Toolpaths} first.
 */
package org.pendant.motion.toolpath;
