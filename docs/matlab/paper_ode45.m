function paper_ode45(history, reltol, abstol, file, kinks)
% PAPER_ODE45  The paper's locomotive section, equations (1)-(7), solved by ode45 and written as CSV.
%
%   paper_ode45('onset',    1e-3,  1e-6,  'onset.csv')          the paper's check: ode45 with its defaults
%   paper_ode45('extended', 1e-10, 1e-12, 'extended.csv')       close to the exact solution
%   paper_ode45('onset',    1e-10, 1e-12, 'tight.csv', 'stop')  the same for a vehicle that enters the profile
%
% Runs under MATLAB and GNU Octave. The equations are read as docs/theory/errata.md reads them, with
% Jk = 70 t m^2; units are SI. The run lasts 10 s from rest; the file has a line every 5 ms:
%
%   t,z1,dz1,z2,dz2,zk,dzk,phi,dphi          the states of (7) in their order [m, m/s, rad, rad/s]
%
% history  'onset': the rail is flat before the profile, so eta' jumps when a wheel arrives (a kink);
%          'extended': the profile has always been there
% reltol   RelTol of ode45 (its default is 1e-3)
% abstol   AbsTol of ode45 (its default is 1e-6)
% file     name of the CSV file
% kinks    'through' (default): one call of ode45 over all kinks, as the paper did. The step that straddles a kink
%          breaks the smoothness that the error estimate builds on: the error stays far above the tolerance.
%          'stop': ode45 is called anew from kink to kink, each time with the rail's one-sided formula

  if nargin < 5
    kinks = 'through';
  end
  if ~any(strcmp(history, {'onset', 'extended'}))
    error('history is "%s", must be "onset" or "extended"', history);
  end
  if ~any(strcmp(kinks, {'through', 'stop'}))
    error('kinks is "%s", must be "through" or "stop"', kinks);
  end

  p = parameters();
  duration = 10;
  times = (0:2000)' * duration / 2000;
  options = odeset('RelTol', reltol, 'AbsTol', abstol);

  borders = [0, duration];
  if strcmp(history, 'onset') && strcmp(kinks, 'stop')
    borders = unique([0, p.delay, duration]);
  end

  states = zeros(numel(times), 8);
  x = zeros(8, 1);
  for k = 1:numel(borders) - 1
    from = borders(k);
    to = borders(k + 1);
    if strcmp(history, 'extended')
      arrived = @(t) true(1, 4);
    elseif strcmp(kinks, 'stop')
      % Decided once per segment: at its end t still belongs to the formula from before the kink.
      arrived = @(t) p.delay <= from;
    else
      arrived = @(t) t >= p.delay;
    end
    % Samples strictly inside, and the ends, so that every call returns exactly these rows.
    inside = find(times > from + 1e-9 & times < to - 1e-9);
    [~, rows] = ode45(@(t, x) right_hand_side(t, x, p, arrived(t)), [from; times(inside); to], x, options);
    states(inside, :) = rows(2:end-1, :);
    x = rows(end, :)';
    at = find(abs(times - to) <= 1e-9);   % empty where a kink falls between samples
    if ~isempty(at)
      states(at, :) = x';
    end
  end

  out = fopen(file, 'w');
  if out < 0
    error('%s cannot be written', file);
  end
  fprintf(out, 't,z1,dz1,z2,dz2,zk,dzk,phi,dphi\n');
  fprintf(out, '%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n', [times, states]');
  fclose(out);
end

function p = parameters()
  p.mk = 57e3;       % carbody mass                          [kg]
  p.Jk = 70e3;       % its pitch inertia                     [kg m^2]
  p.mb = 9e3;        % bogie mass                            [kg]
  p.ak = 3.725;      % half the distance of the bogies       [m]
  p.ab = 1.5;        % half the wheelbase of a bogie         [m]
  p.cb = 3040e3;     % primary stiffness, per axle           [N/m]
  p.bb = 30e3;       % primary damping, per axle             [N s/m]
  p.ck = 2660e3;     % secondary stiffness, per bogie        [N/m]
  p.bk = 100e3;      % secondary damping, per bogie          [N s/m]
  p.V = 20;          % speed                                 [m/s]
  p.a1 = 5e-3;       % amplitude of the harmonic of length L [m]
  p.a2 = 2e-3;       % amplitude of its third harmonic       [m]
  p.w = 2 * pi * p.V / 25;                                     % L = 25 m            [rad/s]
  p.delay = [0, 2 * p.ab, 2 * p.ak, 2 * (p.ab + p.ak)] / p.V;  % wheels 1..4 arrive  [s]
end

% (1): x' = f(t, x), by (7) with x = (z1, z1', z2, z2', zk, zk', phi, phi').
function dx = right_hand_side(t, x, p, arrived)
  [eta, deta] = rail(t, p, arrived);
  z1 = x(1);  dz1 = x(2);  z2 = x(3);  dz2 = x(4);
  zk = x(5);  dzk = x(6);  phi = x(7); dphi = x(8);

  % Forces of the secondary suspensions, positive in elongation.
  Fs1 = p.ck * (zk + p.ak * phi - z1) + p.bk * (dzk + p.ak * dphi - dz1);
  Fs2 = p.ck * (zk - p.ak * phi - z2) + p.bk * (dzk - p.ak * dphi - dz2);

  ddzk = -(Fs1 + Fs2) / p.mk;                                                                                % (2)
  ddphi = -p.ak * (Fs1 - Fs2) / p.Jk;                                                                        % (3)
  ddz1 = (Fs1 + p.cb * (eta(1) + eta(2) - 2 * z1) + p.bb * (deta(1) + deta(2) - 2 * dz1)) / p.mb;            % (4)
  ddz2 = (Fs2 + p.cb * (eta(3) + eta(4) - 2 * z2) + p.bb * (deta(3) + deta(4) - 2 * dz2)) / p.mb;            % (5)
  dx = [dz1; ddz1; dz2; ddz2; dzk; ddzk; dphi; ddphi];
end

% (6): height and its rate under the four wheels; 0 where a wheel has not arrived.
function [eta, deta] = rail(t, p, arrived)
  s = p.w * (t - p.delay);
  eta = arrived .* (p.a1 * sin(s) + p.a2 * sin(3 * s));
  deta = arrived .* (p.w * (p.a1 * cos(s) + 3 * p.a2 * cos(3 * s)));
end
