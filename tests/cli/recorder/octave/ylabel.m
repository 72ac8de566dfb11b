% Stands in for the ylabel of Octave, which needs a graphics toolkit.
function ylabel(text)
end
