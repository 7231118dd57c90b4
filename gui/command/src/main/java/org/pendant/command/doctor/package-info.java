/**
 * What Pendant finds on this computer, for {@code pendant doctor} and for reports of problems. Open
 * {@link org.pendant.command.doctor.Doctor} first; a {@link org.pendant.command.doctor.Finding} is
 * one thing that it says.
 */
package org.pendant.command.doctor;
